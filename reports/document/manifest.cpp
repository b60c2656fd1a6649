#include "reports/document/manifest.hpp"

#include "algebra/number/library_versions.hpp"
#include "reports/document/sha256.hpp"

#include <nlohmann/json.hpp>

namespace limes {

std::string manifest_json(const Manifest& manifest) {
  using Json = nlohmann::ordered_json;
  const auto hashes = [](const Manifest::Files& files) {
    Json list = Json::array();
    for (const auto& [name, content] : files) list.push_back({{"file", name}, {"sha256", sha256(content)}});
    return list;
  };
  Json libraries = Json::object();
  for (const auto& [name, version] : library_versions()) libraries[name] = version;
  const Json json{{"program", "limes"},
                  {"version", manifest.limes_version},
                  {"libraries", libraries},
                  {"command", manifest.command},
                  {"schemes", hashes(manifest.schemes)},
                  {"files", hashes(manifest.outputs)}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace limes
