#include "tests/checker/certificates.hpp"

#include <cctype>
#include <cmath>
#include <iostream>
#include <set>

using namespace limes::test;

// Every JSON node of every valid certificate is deleted, repeated, replaced and exchanged. A mutant that is still valid must
// (1) state something that a table of known facts, which knows nothing of certificates, says is true, and
// (2) be of a kind that is listed with the reason why such a mutation leaves a complete proof.

namespace {

/// A floating-point reader of expressions that are known to be well-formed, to see which masks are the same.
class Value {
 public:
  Value(const std::string& text, const std::map<std::string, double>& values) : text_(text), values_(values) {}
  double sum() {
    double result = product();
    while (next() == '+' || next() == '-') result += text_[at_++] == '+' ? product() : -product();
    return result;
  }

 private:
  char next() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  double product() {
    double result = factor();
    while (next() == '*' || next() == '/') {
      if (text_[at_++] == '*')
        result *= factor();
      else
        result /= factor();
    }
    return result;
  }
  double factor() {
    if (next() == '-') return ++at_, -factor();
    double result = 0;
    if (next() == '(') {
      ++at_;
      result = sum();
      next();
      ++at_;
    } else {
      const std::size_t start = at_;
      while (at_ < text_.size() && std::isalnum(static_cast<unsigned char>(text_[at_]))) ++at_;
      const std::string token = text_.substr(start, at_ - start);
      result = values_.contains(token) ? values_.at(token) : std::stod(token);
    }
    if (next() != '^') return result;
    ++at_;
    next();
    std::size_t length = 0;
    const int exponent = std::stoi(text_.substr(at_), &length);
    at_ += length;
    return std::pow(result, exponent);
  }
  const std::string text_;
  const std::map<std::string, double>& values_;
  std::size_t at_ = 0;
};

/// The mask at sample values of the parameters, or at the only value the region has, without zeros at its ends.
std::vector<double> sampled_mask(const Json& json) {
  std::vector<double> result;
  for (const double sample : {0.3719, 0.4637}) {
    std::map<std::string, double> values;
    for (const auto& [name, interval] : json["claim"]["region"].items()) {
      const auto [low, high] = range(interval);
      values[name] = low + sample * (high - low);
    }
    std::vector<double> mask;
    for (const std::string expression : json["scheme"]["mask"]) mask.push_back(Value(expression, values).sum());
    while (!mask.empty() && std::abs(mask.back()) < 1e-12) mask.pop_back();
    while (!mask.empty() && std::abs(mask.front()) < 1e-12) mask.erase(mask.begin());
    result.insert(result.end(), mask.begin(), mask.end());
  }
  return result;
}

bool same_mask(const Json& json, const Json& known) {
  Json there = known;
  there["claim"]["region"] = json["claim"]["region"];
  if (json["scheme"]["arity"] != known["scheme"]["arity"]) return false;
  for (const std::string name : known["scheme"]["parameters"])
    if (!json["claim"]["region"].contains(name)) return false;
  const auto x = sampled_mask(json), y = sampled_mask(there);
  return std::equal(x.begin(), x.end(), y.begin(), y.end(), [](double a, double b) { return std::abs(a - b) < 1e-9; });
}

/// What is known of the schemes of tests/checker/data: whether "C<m>" (or not) is true on all of a region.
bool is_true(const Json& json) {
  std::string statement = json["claim"]["statement"];
  const bool negated = statement.starts_with("not ");
  const int m = std::stoi(statement.substr(negated ? 5 : 1));
  std::map<std::string, Range> region;
  for (const auto& [name, interval] : json["claim"]["region"].items()) region[name] = range(interval);
  const auto within = [&](const char* name, double low, double high) {
    return region.contains(name) && low <= region[name].low && region[name].high <= high;
  };
  const auto exactly = [&](int smoothness) { return negated ? m > smoothness : m <= smoothness; };

  // A refinable function with n coefficients has a support of length n - 1 and is at most C^{n-3}.
  const bool short_mask = json["scheme"]["arity"] == 2 && m + 1 >= static_cast<int>(sampled_mask(json).size() / 2);
  if (negated && short_mask) return true;
  static const auto all = valid_certificates();
  for (const auto& [name, known] : all) {
    if (!same_mask(json, known)) continue;
    if (name.starts_with("chaikin")) return exactly(1);
    if (name.starts_with("cubic")) return exactly(2);
    if (name == "ternary-linear-not-c1") return exactly(0);
    if (name == "ternary-four-point-c1") return exactly(1);
    if (name == "six-point-c2") return !negated && m <= 2 && within("w", 0.001, 0.042);
    if (name == "two-parameters-c1") return !negated && m <= 1 && within("u", 0, 0.5) && within("v", 0, 0.499);
    if (name == "rational-four-point-c1") return (negated && m >= 2) || (!negated && m <= 1 && within("t", 0, 0.23));
    if (name.starts_with("four-point")) {  // C^1 for 0 < w < 0.19273.., never C^2, C^0 at least for |w| < 1/4
      if (m >= 2) return negated;
      if (negated) return m == 1 && (within("w", 0.193, 1e9) || within("w", -1e9, 0));
      return within("w", m == 1 ? 0 : -0.25, m == 1 ? 0.1927 : 0.25);
    }
  }
  return false;
}

/// The truth of what a certificate says: a refuted statement is one that is false somewhere.
bool says_the_truth(const Json& json) {
  if (json["verdict"] == "certified") return is_true(json);
  // The opposite is true on some leaf.
  for (const Json& leaf : json["proof"]["leaves"]) {
    Json opposite = json;
    const std::string statement = json["claim"]["statement"];
    opposite["claim"]["statement"] = statement.starts_with("not ") ? statement.substr(4) : "not " + statement;
    opposite["claim"]["region"] = leaf["region"];
    if (is_true(opposite)) return true;
  }
  return false;
}

/// The kinds of mutations that leave a complete proof of what is then stated; the reason, or "" for none of them.
std::string why_it_may_survive(const std::string& path, const Json& before, const Json& after) {
  const auto is = [&](const std::string& part) { return path.find(part) != std::string::npos; };
  if (path == "/scheme/name") return "the name is a label";
  if (path == "/scheme/first_index") return "a shift of the mask changes no smoothness";
  if (path == "/scheme") return "the proof also holds for the other scheme";
  if (path == "/scheme/mask" || is("/scheme/mask/")) return "another scheme, or a shifted one, with the same proof";
  if (path == "/claim/statement") return "an easier statement with the same proof";
  if (path == "/claim" || is("/claim/region")) return "a smaller or equal region, or an easier statement";
  if (is("/proof/leaves/") && is("/level")) return "another level at which the norm is below 1";
  if (is("/proof/leaves/") && is("/word")) return "another word whose product has spectral radius at least 1";
  if (is("/proof/leaves/") && is("/region")) return "the leaves still cover, or the refutation holds on another leaf";
  if (path == "/proof" || is("/proof/leaves"))
    return "another complete proof: leaves repeated, superfluous or exchanged";
  if (path == "/proof/stability") return "the scheme is stable for both reasons";
  if (is("/scheme/parameters/")) return "the order of the parameters means nothing";
  if (path == "/verdict" || path == "/theorem") return "";
  return before == after ? "nothing changed" : "";
}

class Mutants {
 public:
  void examine(const std::string& path, const Json& before, const Json& mutant, const Json& after) {
    ++count_;
    const auto result = check(mutant);
    if (!result.valid) {
      EXPECT_FALSE(result.step.empty() || result.reason.empty());
      EXPECT_NE(result.step, "internal") << result.reason << mutant.dump();
      return;
    }
    EXPECT_TRUE(says_the_truth(mutant)) << path << '\n' << result.statement << '\n' << mutant.dump();
    const std::string why = why_it_may_survive(path, before, after);
    EXPECT_FALSE(why.empty()) << path << '\n' << result.statement << '\n' << mutant.dump();
    ++survivors_[why];
  }

  ~Mutants() {
    std::cout << count_ << " mutants; survivors:\n";
    for (const auto& [why, n] : survivors_) std::cout << "  " << n << " - " << why << '\n';
  }

 private:
  std::size_t count_ = 0;
  std::map<std::string, std::size_t> survivors_;
};

std::vector<std::string> paths(const Json& json) {
  std::vector<std::string> result;
  const Json flat = json.flatten();
  for (const auto& [path, value] : flat.items()) {
    for (std::size_t slash = path.find('/', 1);; slash = path.find('/', slash + 1)) {
      result.push_back(path.substr(0, slash));
      if (slash == std::string::npos) break;
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Calls visit(path, mutated) for every node and every value that may replace it.
void replace_all(const Json& json, const std::vector<Json>& values, Mutants& mutants) {
  for (const auto& path : paths(json)) {
    const Json::json_pointer pointer(path);
    for (const auto& value : values) {
      if (value == json[pointer]) continue;
      Json mutant = json;
      mutant[pointer] = value;
      mutants.examine(path, json[pointer], mutant, value);
    }
  }
}

}  // namespace

TEST(Mutation, ReplacedNodes) {
  const std::vector<Json> values{nullptr,
                                 true,
                                 false,
                                 0,
                                 1,
                                 -1,
                                 2,
                                 3,
                                 17,
                                 25,
                                 1.0,
                                 1.5,
                                 1e300,
                                 1000000000000000000,
                                 "",
                                 "0",
                                 "1",
                                 "-1",
                                 "1/16",
                                 "-1/2",
                                 "1/0",
                                 "w",
                                 "u",
                                 "x y",
                                 "C0",
                                 "C1",
                                 "C2",
                                 "C3",
                                 "C65",
                                 "C01",
                                 "C-1",
                                 "not C0",
                                 "not C1",
                                 "not C2",
                                 "not C3",
                                 "[0, 1]",
                                 "(0, 1/8]",
                                 "[1/16, 1/8]",
                                 "(1/16, 1/8)",
                                 "[1/8, 1/16]",
                                 "[1/5, 1/4]",
                                 "U1",
                                 "U2",
                                 "U3",
                                 "certified",
                                 "refuted",
                                 "undecided",
                                 "uniform",
                                 "nonuniform",
                                 "interpolatory",
                                 "linear-independence",
                                 "limes-certificate",
                                 std::string(20000, '9'),
                                 Json::array(),
                                 Json::object(),
                                 Json::array({0}),
                                 Json::array({"0"}),
                                 Json::array({Json::array()}),
                                 Json{{"w", "1/16"}},
                                 Json{{"w", "(0, 1/16)"}},
                                 Json{{"region", Json::object()}}};
  Mutants mutants;
  for (const auto& [name, json] : valid_certificates()) replace_all(json, values, mutants);
}

TEST(Mutation, DeletedAndRepeatedNodes) {
  Mutants mutants;
  for (const auto& [name, json] : valid_certificates()) {
    for (const auto& path : paths(json)) {
      const Json::json_pointer pointer(path);
      const Json before = json[pointer];
      Json deleted = json, repeated = json, extended = json;
      Json& parent = deleted[pointer.parent_pointer()];
      if (parent.is_object()) {
        parent.erase(pointer.back());
        repeated[pointer.parent_pointer()][pointer.back() + "2"] = before;
      } else {
        const auto index = std::stol(pointer.back());
        parent.erase(parent.begin() + index);
        Json& list = repeated[pointer.parent_pointer()];
        list.insert(list.begin() + index, before);
      }
      mutants.examine(path, before, deleted, nullptr);
      mutants.examine(path, before, repeated, nullptr);
      if (before.is_object()) {
        extended[pointer]["unknown"] = 1;
        mutants.examine(path + "/unknown", nullptr, extended, 1);
        const auto result = check(extended);
        EXPECT_FALSE(result.valid) << "an unknown key was accepted: " << path;
      }
      if (before.is_array()) {
        for (const Json& extra : {Json("0"), Json(0), Json::object(), Json()}) {
          extended[pointer] = before;
          extended[pointer].push_back(extra);
          mutants.examine(path + "/", nullptr, extended, extra);
        }
      }
    }
  }
}

TEST(Mutation, NodesExchangedWithOtherCertificates) {
  Mutants mutants;
  const auto all = valid_certificates();
  for (const auto& [name, json] : all) {
    for (const auto& [other_name, other] : all) {
      if (name == other_name) continue;
      for (const auto& path : paths(json)) {
        const Json::json_pointer pointer(path);
        if (!other.contains(pointer) || other[pointer] == json[pointer]) continue;
        Json mutant = json;
        mutant[pointer] = other[pointer];
        mutants.examine(path, json[pointer], mutant, other[pointer]);
      }
    }
  }
}

TEST(Mutation, NodesExchangedWithinACertificate) {
  Mutants mutants;
  for (const auto& [name, json] : valid_certificates()) {
    const auto all = paths(json);
    for (const auto& path : all) {
      for (const auto& other : all) {
        if (other <= path || other.starts_with(path) ||
            json[Json::json_pointer(path)] == json[Json::json_pointer(other)])
          continue;
        Json mutant = json;
        mutant[Json::json_pointer(path)] = json[Json::json_pointer(other)];
        mutant[Json::json_pointer(other)] = json[Json::json_pointer(path)];
        mutants.examine(path, json[Json::json_pointer(path)], mutant, json[Json::json_pointer(other)]);
      }
    }
  }
}

TEST(Mutation, EveryCharacterOfEveryString) {
  Mutants mutants;
  for (const auto& [name, json] : valid_certificates()) {
    for (const auto& path : paths(json)) {
      const Json::json_pointer pointer(path);
      if (!json[pointer].is_string() || path == "/scheme/name") continue;
      const std::string text = json[pointer];
      std::set<std::string> variants;
      for (std::size_t i = 0; i <= text.size(); ++i) {
        for (const char c : std::string("0123456789-+*/^()[], wC")) {
          if (i < text.size()) variants.insert(text.substr(0, i) + c + text.substr(i + 1));
          variants.insert(text.substr(0, i) + c + text.substr(i));
        }
        if (i < text.size()) variants.insert(text.substr(0, i) + text.substr(i + 1));
      }
      variants.erase(text);
      for (const auto& variant : variants) {
        Json mutant = json;
        mutant[pointer] = variant;
        mutants.examine(path, text, mutant, variant);
      }
    }
  }
}
