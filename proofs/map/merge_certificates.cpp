#include "proofs/map/merge_certificates.hpp"

#include "algebra/error.hpp"
#include "proofs/certificate_text_impl.hpp"

namespace limes {
namespace {

using Json = nlohmann::ordered_json;

/// Lists of leaves are joined, all else has to be equal.
bool join(Json& target, const Json& other) {
  if (!target.is_object() || !other.is_object()) return target == other;
  if (target.size() != other.size()) return false;
  for (auto& [key, value] : target.items()) {
    if (!other.contains(key)) return false;
    if ((key == "leaves" || key == "dominance" || key == "mirrored") && value.is_array() && other[key].is_array()) {
      value.insert(value.end(), other[key].begin(), other[key].end());
    } else if (!join(value, other[key])) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::optional<std::string> merge_certificates(const std::vector<std::string>& certificates, const Box& region,
                                              const VariableNames& parameters) {
  try {
    Json claimed = Json::object();
    for (std::size_t k = 0; k < parameters.size(); ++k) claimed[parameters[k]] = to_string(region[k]);
    std::optional<Json> result;
    for (const std::string& text : certificates) {
      Json next = Json::parse(text);
      next.at("claim").at("region") = claimed;
      // Theorem N3 writes a single leaf as the proof itself.
      if (Json& proof = next.at("proof"); proof.contains("gamma")) proof = {{"leaves", Json::array({proof})}};
      if (!result) {
        result = std::move(next);
      } else if (!join(*result, next)) {
        return std::nullopt;
      }
    }
    if (!result) return std::nullopt;
    return certificate_text(*result);
  } catch (const Json::exception& error) {
    throw DomainError(fmt::format("merge_certificates: {}", error.what()));
  }
}

}  // namespace limes
