// SPDX-License-Identifier: MIT
#include "proofs/checker/json.hpp"

#include <set>

namespace limes::checker {
namespace {

/// Sees every key and value before the document is built. (The library's parser with a callback takes quadratic time.)
struct Watch : nlohmann::json_sax<Json> {
  std::vector<std::set<std::string>> keys;  // of the open objects and lists
  std::size_t events = 0;

  bool count() {
    return ++events <= 2000000 ? true : throw Rejected{"limits", "the text has more than 2000000 keys and values"};
  }
  bool open() {
    keys.emplace_back();
    return keys.size() <= 32 ? count() : throw Rejected{"json", "the text is nested more than 32 deep"};
  }
  bool close() { return keys.pop_back(), true; }
  bool key(std::string& name) override {
    if (!keys.back().insert(name).second) throw Rejected{"json", "the key " + checker::quoted(name) + " occurs twice"};
    return count();
  }
  bool parse_error(std::size_t byte, const std::string&, const nlohmann::detail::exception&) override {
    throw Rejected{"json", "the text is no JSON near byte " + std::to_string(byte)};
  }
  bool null() override { return count(); }
  bool boolean(bool) override { return count(); }
  bool number_integer(Json::number_integer_t) override { return count(); }
  bool number_unsigned(Json::number_unsigned_t) override { return count(); }
  bool number_float(Json::number_float_t, const std::string&) override { return count(); }
  bool string(std::string&) override { return count(); }
  bool binary(Json::binary_t&) override { return count(); }
  bool start_object(std::size_t) override { return open(); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(); }
  bool end_array() override { return close(); }
};

}  // namespace

Json parse_json(std::string_view text) {
  if (text.size() > std::size_t{64} << 20) throw Rejected{"limits", "the certificate has more than 64 MiB"};
  if (text.starts_with("\xEF\xBB\xBF")) throw Rejected{"json", "the text starts with a byte order mark"};
  // The library would take a NUL for the end of the text.
  if (text.find('\0') != std::string_view::npos) throw Rejected{"json", "the text contains a NUL byte"};
  Watch watch;
  Json::sax_parse(text, &watch);
  return Json::parse(text);
}

}  // namespace limes::checker
