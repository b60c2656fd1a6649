#include "apps/limes/json_output.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/session.hpp"

#include "analysis/uniform/difference_symbol.hpp"
#include "analysis/uniform/stability.hpp"
#include "schemes/catalogue.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>

namespace limes::app {
namespace {

std::vector<std::string> texts(const LaurentPolynomial& symbol, const VariableNames& names, bool latex) {
  std::vector<std::string> result;
  for (const RationalFunction& c : symbol.coefficients()) result.push_back(latex ? to_latex(c, names) : to_string(c, names));
  return result;
}

std::string stability_text(const Mask& mask) {
  const std::optional<Stability> stability = prove_stability(mask);
  if (!stability) return "not proved";
  return *stability == Stability::interpolatory ? "interpolatory" : "integer shifts linearly independent";
}

std::string reproduction_text(const PolynomialDegrees& degrees, const VariableNames& names) {
  if (degrees.generation < 0) return "none (a(1) is not the arity)";
  std::string text = fmt::format("generates degree {}, reproduces degree {}", degrees.generation, degrees.reproduction);
  if (degrees.reproduction >= 1) text += fmt::format(" with parameters t_i = i + {}", to_string(degrees.parameter_shift, names));
  return text;
}

std::string symbol_text(const Mask& mask, int order) {
  const int p = mask.arity;
  const std::string sigma = p == 2 ? "(1+z)" : fmt::format("(1+...+z^{})", p - 1);
  return fmt::format("{}^{} {}^{} b(z)", sigma, order, p, 1 - order);
}

void print_text(const Scheme& scheme) {
  const VariableNames names = scheme.parameter_names();
  const Mask& mask = scheme.mask;
  const int order = sum_rule_order(mask);
  const LaurentPolynomial b = *difference_symbol(mask, order);
  std::cout << fmt::format("{}: {}\n", scheme.name, scheme.title);
  const auto line = [](const std::string& key, const std::string& value) { std::cout << fmt::format("  {:<14}{}\n", key, value); };
  line("kind", fmt::format("{}, arity {}", to_string(scheme.kind), mask.arity));
  if (!scheme.sources.empty()) line("source", fmt::format("{}", fmt::join(scheme.sources, ", ")));
  if (!scheme.parameters.empty()) line("parameters", region_text(scheme, scheme.parameter_box()));
  if (scheme.insertion_rule) {
    const InsertionRuleText& text = scheme.insertion_rule->text();
    line("points", fmt::format("{}", scheme.insertion_rule->points()));
    for (const auto& [name, value] : text.let) line("let", fmt::format("{} = {}", name, value.text));
    for (std::size_t j = 0; j < text.coefficients.size(); ++j) line("coefficient", fmt::format("e_{} = {}", j + 1, text.coefficients[j].text));
  }
  if (!scheme.rule.empty()) line("rule", scheme.rule);
  line("mask", fmt::format("a_{} .. a_{} = {}", mask.symbol.lowest(), mask.symbol.highest(),
                           fmt::join(texts(mask.symbol, names, false), ", ")));
  line("symbol", fmt::format("a(z) = {}", symbol_text(mask, order)));
  line("", fmt::format("b_{} .. b_{} = {}", b.lowest(), b.highest(), fmt::join(texts(b, names, false), ", ")));
  line("sum rules", fmt::format("order {}", order));
  line("polynomials", reproduction_text(polynomial_degrees(mask), names));
  line("stability", stability_text(mask));
  for (const Claim& claim : scheme.claims) {
    const std::string expected = claim.expected == Outcome::certified ? "" : fmt::format(", expected {}", to_string(claim.expected));
    line("claim", fmt::format("{}, {}{}{}", statement(claim), region_text(scheme, claim.region),
                              claim.source.empty() ? "" : " [" + claim.source + "]", expected));
  }
}

void print_latex(const Scheme& scheme) {
  const VariableNames names = scheme.parameter_names();
  const int order = sum_rule_order(scheme.mask);
  const int p = scheme.mask.arity;
  const LaurentPolynomial b = *difference_symbol(scheme.mask, order);
  const auto power = [](int exponent, const std::string& c) -> std::string {
    if (exponent == 0) return c == "1" ? "1" : "";
    return exponent == 1 ? "z" : fmt::format("z^{{{}}}", exponent);
  };
  const auto polynomial = [&](const LaurentPolynomial& symbol) {
    std::string text;
    int exponent = symbol.lowest();
    for (const std::string& c : texts(symbol, names, true)) {
      if (c != "0") text += fmt::format("{}{}{}", text.empty() ? "" : "+", c == "1" ? "" : "\\left(" + c + "\\right)", power(exponent, c));
      ++exponent;
    }
    return text;
  };
  const std::string sigma = p == 2 ? "1+z" : p == 3 ? "1+z+z^{2}" : fmt::format("1+z+\\dots+z^{{{}}}", p - 1);
  std::cout << fmt::format("\\begin{{align*}}\n  a(z) &= {}\\\\\n       &= ({})^{{{}}}\\,{}^{{{}}}\\,b(z),\\\\\n  b(z) &= {}.\n\\end{{align*}}\n",
                           polynomial(scheme.mask.symbol), sigma, order, p, 1 - order, polynomial(b));
}

}  // namespace

int run_show(const ShowOptions& options) {
  const Scheme scheme = load_scheme(options.scheme);
  if (options.json) {
    std::cout << show_json(scheme);
  } else if (options.latex) {
    print_latex(scheme);
  } else {
    print_text(scheme);
  }
  return all_as_expected;
}

}  // namespace limes::app
