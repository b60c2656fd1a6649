// GiNaC prints the numbers and the powers of symbols; their order is ours, because GiNaC orders the terms of a sum and
// the factors of a product by hashes of addresses, which differ from run to run.
#include "algebra/polynomial/rational_function.hpp"

#include "algebra/error.hpp"
#include "algebra/number/ginac_conversion.hpp"

#include <ginac/ginac.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <mutex>
#include <sstream>
#include <string_view>

namespace limes {

namespace {

// GiNaC counts references and numbers symbols without locks.
std::mutex& ginac_mutex() {
  static std::mutex mutex;
  return mutex;
}

constexpr std::string_view greek_names[] = {
    "Delta", "Gamma", "Lambda", "Omega",   "Phi",   "Pi",    "Psi",   "Sigma",   "Theta",  "Upsilon", "Xi", "alpha",
    "beta",  "chi",   "delta",  "epsilon", "eta",   "gamma", "iota",  "kappa",   "lambda", "mu",      "nu", "omega",
    "phi",   "pi",    "psi",    "rho",     "sigma", "tau",   "theta", "upsilon", "xi",     "zeta"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// One part of a name: a Greek letter, a number, a letter, or a word in upright type.
std::string latex_word(std::string_view word) {
  if (std::find(std::begin(greek_names), std::end(greek_names), word) != std::end(greek_names))
    return fmt::format("\\{}", word);
  if (word.size() == 1 || std::all_of(word.begin(), word.end(), is_digit)) return std::string(word);
  return fmt::format("\\mathrm{{{}}}", word);
}

// "beta_1" and "beta1" become \beta_{1}, "w_left_2" becomes w_{\mathrm{left},2}.
std::string latex_name(std::string_view name) {
  std::vector<std::string> parts;
  for (std::size_t start = 0; start < name.size();) {
    if (name[start] == '_') {
      ++start;
      continue;
    }
    std::size_t end = start + 1;
    while (end < name.size() && name[end] != '_' && is_digit(name[end]) == is_digit(name[start])) ++end;
    parts.push_back(latex_word(name.substr(start, end - start)));
    start = end;
  }
  std::string result = parts.empty() ? "\\_" : parts.front();
  if (parts.size() > 1) result += fmt::format("_{{{}}}", fmt::join(parts.begin() + 1, parts.end(), ","));
  return result;
}

std::string printed(const GiNaC::ex& expression) {
  std::ostringstream out;
  out << GiNaC::latex << expression;
  return out.str();
}

// A term without its sign: 3 w^2 / 4 becomes \frac{3 w^{2}}{4}.
std::string latex_term(const MultivariatePolynomial::Term& term, const std::vector<GiNaC::symbol>& symbols) {
  const Rational modulus = abs(term.coefficient);
  std::vector<std::string> factors;
  if (numerator(modulus) != 1) factors.push_back(printed(to_ginac(numerator(modulus))));
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    if (term.exponents[i] != 0) factors.push_back(printed(GiNaC::pow(symbols[i], term.exponents[i])));
  }
  if (factors.empty()) factors.push_back("1");
  const std::string product = fmt::format("{}", fmt::join(factors, " "));
  if (denominator(modulus) == 1) return product;
  return fmt::format("\\frac{{{}}}{{{}}}", product, printed(to_ginac(denominator(modulus))));
}

// Terms in descending lexicographic order.
std::string latex_sum(const std::vector<MultivariatePolynomial::Term>& terms,
                      const std::vector<GiNaC::symbol>& symbols) {
  if (terms.empty()) return "0";
  std::string result;
  for (const auto& term : terms) {
    if (term.coefficient < 0) {
      result += '-';
    } else if (!result.empty()) {
      result += '+';
    }
    result += latex_term(term, symbols);
  }
  return result;
}

using Terms = std::vector<MultivariatePolynomial::Term>;

// Makes all coefficients of both integers without a common factor, the first one of the numerator positive; returns
// whether the sign was changed.
bool make_integer(Terms& above, Terms& below) {
  Integer common = 1;
  Integer content = 0;
  for (const Terms* terms : {&above, &below})
    for (const auto& term : *terms) common = lcm(common, denominator(term.coefficient));
  for (const Terms* terms : {&above, &below})
    for (const auto& term : *terms) content = gcd(content, numerator(Rational(term.coefficient * common)));
  const bool negative = above.front().coefficient < 0;
  const Rational factor(common, content);
  for (auto& term : above) term.coefficient *= negative ? Rational(-factor) : factor;
  for (auto& term : below) term.coefficient *= factor;
  return negative;
}

}  // namespace

std::string to_latex(const RationalFunction& a, const VariableNames& names) {
  if (int(names.size()) != a.variables()) {
    throw DomainError(fmt::format("{} names were given for {} variables", names.size(), a.variables()));
  }
  const std::scoped_lock lock(ginac_mutex());
  std::vector<GiNaC::symbol> symbols;
  for (const auto& name : names) symbols.emplace_back(name, latex_name(name));
  Terms above = a.numerator().terms();
  Terms below = a.denominator().terms();
  if (a.is_polynomial()) return latex_sum(above, symbols);
  const bool negative = make_integer(above, below);
  return fmt::format("{}\\frac{{{}}}{{{}}}", negative ? "-" : "", latex_sum(above, symbols), latex_sum(below, symbols));
}

}  // namespace limes
