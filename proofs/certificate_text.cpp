#include "proofs/certificate_text_impl.hpp"

#include <algorithm>

namespace limes {
namespace {

using Json = nlohmann::ordered_json;

bool holds_object(const Json& json) {
  return json.is_object() || (json.is_array() && std::any_of(json.begin(), json.end(), holds_object));
}

void print(const Json& json, std::size_t indent, std::string& out) {
  constexpr std::size_t one_line = 110;
  const bool splits = json.is_array() && !json.empty() && json.front().is_array();
  if (!holds_object(json)) {
    const std::string line = json.dump();
    if (!splits || line.size() + indent <= one_line) {
      out += line;
      return;
    }
  }
  const char* const ends = json.is_object() ? "{}" : "[]";
  out += ends[0];
  bool first = true;
  for (auto item = json.begin(); item != json.end(); ++item) {
    if (!first) out += ',';
    first = false;
    out += '\n' + std::string(indent + 1, ' ');
    if (json.is_object()) out += Json(item.key()).dump() + ": ";
    print(*item, indent + 1, out);
  }
  out += '\n' + std::string(indent, ' ') + ends[1];
}

}  // namespace

std::string certificate_text(const Json& json) {
  std::string text;
  print(json, 0, text);
  return text + "\n";
}

}  // namespace limes
