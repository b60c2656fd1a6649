// SPDX-License-Identifier: MIT
//
// The only source that knows JSON.
#include "proofs/checker/certificate.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace limes::checker {
namespace {

using Json = nlohmann::json;

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

/// JSON without duplicate keys, byte order mark or NUL (which the library would take for the end of the text).
Json parse(std::string_view text) {
  if (text.size() > std::size_t{64} << 20) throw Rejected{"limits", "the certificate has more than 64 MiB"};
  if (text.starts_with("\xEF\xBB\xBF")) throw Rejected{"json", "the text starts with a byte order mark"};
  if (text.find('\0') != std::string_view::npos) throw Rejected{"json", "the text contains a NUL byte"};
  Watch watch;
  Json::sax_parse(text, &watch);
  return Json::parse(text);
}

/// One object with exactly the keys given; every failure names the step and the place.
class Reader {
 public:
  Reader(const Json& json, std::string step, std::string where, std::vector<std::string> keys)
      : json_(json), step_(std::move(step)), where_(std::move(where)) {
    if (!json_.is_object()) fail("is no object");
    for (const auto& key : keys)
      if (!json_.contains(key)) fail("lacks the key " + key);
    for (const auto& [key, value] : json_.items())
      if (std::count(keys.begin(), keys.end(), key) == 0) fail("has the unknown key " + checker::quoted(key));
  }

  [[noreturn]] void fail(const std::string& why) const { throw Rejected{step_, where_ + " " + why}; }
  const Json& at(const char* key) const { return json_.at(key); }

  const std::string& text(const Json& value, const std::string& what) const {
    if (!value.is_string()) fail("needs a string as " + what);
    return value.get_ref<const std::string&>();
  }
  int integer(const Json& value, const std::string& what, int low, int high) const {
    const bool huge = value.is_number_unsigned() && value.get<std::uint64_t>() >= 1u << 31;
    if (!value.is_number_integer() || huge || value.get<std::int64_t>() < low || value.get<std::int64_t>() > high)
      fail("needs an integer from " + std::to_string(low) + " to " + std::to_string(high) + " as " + what);
    return value.get<int>();
  }
  const Json& list(const char* key, std::size_t least, std::size_t most) const {
    if (!at(key).is_array() || at(key).size() < least || at(key).size() > most)
      fail("needs a list of " + std::to_string(least) + " to " + std::to_string(most) + " elements as " + key);
    return at(key);
  }
  /// Whether a text is the first of two choices; it must be one of them.
  bool is_first(const char* key, std::string_view first, std::string_view second) const {
    const std::string& value = text(at(key), key);
    if (value != first && value != second) fail("has an unknown " + std::string(key));
    return value == first;
  }
  Region region(const std::vector<std::string>& parameters, Budget& budget) const {
    Region result;
    const Reader intervals(at("region"), step_, where_ + ": the region", parameters);
    for (const auto& parameter : parameters) {
      const std::string& interval = text(intervals.json_.at(parameter), "the interval of " + parameter);
      budget.work(2000 + 2. * static_cast<double>(interval.size() * interval.size()));
      budget.hold(300 + 2. * static_cast<double>(interval.size()));
      result.push_back(read_interval(interval, step_));
    }
    return result;
  }

 private:
  const Json& json_;
  std::string step_, where_;
};

Scheme read_scheme(const Json& json, Budget& budget) {
  const Reader reader(json, "scheme", "the scheme", {"kind", "name", "parameters", "arity", "first_index", "mask"});
  reader.is_first("kind", "uniform", "uniform");
  Scheme scheme{reader.text(reader.at("name"), "name"), {}, 0, {}, constant(1)};
  if (scheme.name.empty() || scheme.name.size() > 200) reader.fail("needs a name of 1 to 200 bytes");
  unsigned char before = 0;
  for (const char c : scheme.name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F || (before == 0xC2 && byte < 0xA0)) reader.fail("needs a printable name");
    before = byte;
  }
  scheme.arity = reader.integer(reader.at("arity"), "arity", 2, 16);
  for (const Json& name : reader.list("parameters", 0, max_parameters)) {
    if (!is_name(reader.text(name, "a parameter"))) reader.fail("has a parameter that is no name");
    if (std::count(scheme.parameters.begin(), scheme.parameters.end(), name) > 0) reader.fail("has a parameter twice");
    scheme.parameters.push_back(name);
  }
  reader.integer(reader.at("first_index"), "first_index", -1000000, 1000000);
  std::vector<Fraction> mask;
  std::vector<Polynomial> denominators;  // the distinct ones; D is their product
  for (const Json& expression : reader.list("mask", 1, 1024)) {
    mask.push_back(read_expression(reader.text(expression, "an element of the mask"), scheme.parameters, budget));
    const Polynomial& own = mask.back().denominator;
    if (std::count(denominators.begin(), denominators.end(), own) == 0) denominators.push_back(own);
  }
  for (const auto& d : denominators) scheme.denominator = multiply(scheme.denominator, d, budget);
  for (auto& [numerator, own] : mask) {
    for (const auto& d : denominators)
      if (d != own) numerator = multiply(numerator, d, budget);
    scheme.mask.push_back(std::move(numerator));
  }
  return scheme;
}

Leaf read_leaf(const Json& json, const std::string& where, const Certificate& certificate, Budget& budget) {
  const bool missing = !certificate.theorem_u1 && json.is_object() && json.contains("missing_factor");
  const char* witness = certificate.theorem_u1 ? "level" : missing ? "missing_factor" : "word";
  const Reader reader(json, "proof", where, {"region", witness});
  Leaf leaf{reader.region(certificate.scheme.parameters, budget), 0, missing, {}};
  if (certificate.theorem_u1) {
    leaf.level = reader.integer(reader.at("level"), "level", 1, 24);
  } else if (missing) {
    if (reader.at("missing_factor") != true) reader.fail("needs true as missing_factor");
  } else {
    for (const Json& letter : reader.list("word", 1, 64))
      leaf.word.push_back(reader.integer(letter, "a letter", 0, certificate.scheme.arity - 1));
  }
  return leaf;
}

}  // namespace

Certificate read_certificate(std::string_view text, Budget& budget) {
  const Json json = parse(text);
  const Reader reader(json, "format", "the certificate",
                      {"format", "version", "scheme", "claim", "verdict", "theorem", "proof"});
  reader.is_first("format", "limes-certificate", "limes-certificate");
  reader.integer(reader.at("version"), "version", 1, 1);
  Certificate result;
  result.certified = reader.is_first("verdict", "certified", "refuted");
  result.theorem_u1 = reader.is_first("theorem", "U1", "U2");
  result.scheme = read_scheme(json["scheme"], budget);

  const Reader claim(json["claim"], "claim", "the claim", {"statement", "region"});
  std::string statement = claim.text(claim.at("statement"), "statement");
  if ((result.negated = statement.starts_with("not "))) statement.erase(0, 4);
  while (result.order <= 64 && statement != "C" + std::to_string(result.order)) ++result.order;
  if (result.order > 64) claim.fail("needs C<m> or not C<m> with m from 0 to 64 as statement");
  result.region = claim.region(result.scheme.parameters, budget);
  // U1 proves C^m and so refutes not C^m; U2 the other way round.
  if (result.theorem_u1 == (result.certified == result.negated)) claim.fail("is not what the theorem can decide so");

  std::vector<std::string> keys{"leaves"};
  if (!result.theorem_u1) keys.push_back("stability");
  const Reader proof(json["proof"], "proof", "the proof", keys);
  result.interpolatory = !result.theorem_u1 && proof.is_first("stability", "interpolatory", "linear-independence");
  for (const Json& leaf : proof.list("leaves", 1, 100000))
    result.leaves.push_back(read_leaf(leaf, "leaf " + std::to_string(result.leaves.size() + 1), result, budget));
  return result;
}

}  // namespace limes::checker
