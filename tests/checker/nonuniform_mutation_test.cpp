#include "tests/checker/nonuniform.hpp"

#include <functional>
#include <iostream>

using namespace limes::test;

// Valid certificates of theorems N1 and N3 in which single characters, numbers and list elements are altered. A mutant
// that is still valid states the same about the same scheme (another proof of it, or another name), or less; or what a
// table of facts that knows nothing of certificates says is true.

namespace {

/// Whether "C^m", or "not C^m", holds for all w in the range.
using Fact = std::function<bool(bool negated, int m, Range w)>;

bool is_true(const Json& claim, const Fact& fact) {
  std::string statement = claim["statement"];
  const bool negated = statement.starts_with("not ");
  if (negated) statement.erase(0, 4);
  const Range w = claim["region"].contains("w") ? range(claim["region"]["w"]) : Range{0, 0};
  return fact(negated, std::stoi(statement.substr(1)), w);
}

class Mutants {
 public:
  Mutants(std::string name, Json original, Fact fact)
      : name_(std::move(name)), original_(std::move(original)), fact_(std::move(fact)) {
    expect_valid(original_);
    mutate(original_);
    std::cout << name_ << ": " << count_ << " mutants, " << proofs_ << " other proofs, " << claims_ << " other claims, "
              << schemes_ << " other schemes\n";
  }

 private:
  /// Alters the part `node` of mutant_, which is original_ otherwise.
  void mutate(const Json& node, const Json::json_pointer& at = Json::json_pointer{}) {
    if (node.is_object())
      for (const auto& [key, value] : node.items()) mutate(value, at / key);
    if (node.is_array())
      for (std::size_t k = 0; k < node.size(); ++k) {
        mutate(node[k], at / k);
        Json shorter = node;
        shorter.erase(k);
        replace(at, shorter);
      }
    if (node.is_number_integer())
      for (const int step : {-1, 1}) replace(at, node.get<int>() + step);
    if (!node.is_string()) return;
    const std::string text = node;
    for (std::size_t k = 0; k < text.size(); ++k) {
      std::string shorter = text;
      replace(at, shorter.erase(k, 1));
      for (const char c : std::string("012579-+/([w")) {
        std::string changed = text;
        changed[k] = c;
        if (c != text[k]) replace(at, changed);
      }
    }
  }
  void replace(const Json::json_pointer& at, const Json& value) {
    Json mutant = original_;
    mutant[at] = value;
    ++count_;
    const auto result = check(mutant);
    EXPECT_NE(result.step, "internal") << mutant.dump();
    if (!result.valid || at.to_string() == "/scheme/name") return;
    if (mutant["scheme"] != original_["scheme"]) {
      ++schemes_;
      EXPECT_TRUE(same_scheme(mutant["scheme"])) << at.to_string() << ": " << mutant.dump();
    } else if (mutant["claim"] != original_["claim"]) {
      ++claims_;
      EXPECT_TRUE(is_true(mutant["claim"], fact_)) << mutant["claim"].dump();
    } else {
      ++proofs_;  // of what is true
    }
  }
  /// Blanks mean nothing; and an altered rule is rough, too, more often than not: without the polynomials.
  bool same_scheme(const Json& scheme) const {
    const auto without_blanks = [](const Json& json) {
      std::string text = json.dump();
      text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
      return text;
    };
    return original_["theorem"] == "N3" || without_blanks(scheme) == without_blanks(original_["scheme"]);
  }

  std::string name_;
  Json original_;
  Fact fact_;
  int count_ = 0, proofs_ = 0, claims_ = 0, schemes_ = 0;
};

/// C^1 for 0 < w < end, never C^2.
Fact smooth_below(double end) {
  return [end](bool negated, int m, Range w) {
    if (negated) return m >= 2 || (m == 1 && (w.low > end || w.high <= 0));
    return m == 0 || (m == 1 && w.low > 0 && w.high < end);
  };
}

}  // namespace

TEST(NonuniformMutation, SmoothForEveryKnotSequence) {
  Mutants("cr1", cr1("[1/16, 1/8]", 4, {{0, "rouche"}, {1, "circle"}, {2, "boundary"}}), smooth_below(0.19274));
  Mutants("separated", separated("1/10", {"1/10", "1/2"}, {"1/10"}), smooth_below(0.125));
  Mutants("one-sided", one_sided(), smooth_below(1));
}

TEST(NonuniformMutation, RoughForSomeKnotSequence) {
  const Json leaves = {{{"region", {{"w", "[13/100, 1/5)"}}}, {"gamma", "1/64"}},
                       {{"region", {{"w", "[1/5, 1/4]"}}}, {"gamma", "64"}}};
  Mutants("region",
          nonuniform(4, Let{}, a131_rule, "not C1", {{"w", "[13/100, 1/4]"}}, "certified", "N3", {{"leaves", leaves}}),
          smooth_below(0.125));
  Mutants(
      "point", n3(a131_rule, "C1", "[1/100, 18/100]", "refuted", "13/100", "1/50"),
      [](bool negated, int m, Range w) { return !negated && (m > 1 || (m == 1 && (w.high > 0.125 || w.low <= 0))); });
}
