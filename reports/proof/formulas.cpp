#include "reports/proof/formulas.hpp"

#include "algebra/number/read_rational.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace limes {
namespace {

/// Quotients of numbers are set small: they stand in sums.
std::string with_small_fractions(std::string latex) {
  for (std::size_t at = 0; (at = latex.find("\\frac{", at)) != std::string::npos; at += 7) latex.insert(at + 1, "t");
  return latex;
}

/// "\tfrac12-4w" rather than "-4w+\tfrac12": a term with a positive sign first, if there is one.
std::string polynomial_latex(const MultivariatePolynomial& p, const VariableNames& names) {
  std::vector<std::string> terms;
  for (const auto& term : p.terms()) {
    const std::string latex = to_latex(RationalFunction(MultivariatePolynomial::from_terms(p.variables(), {term})), names);
    terms.push_back(latex.starts_with('-') ? latex : "+" + latex);
  }
  if (!terms.empty() && terms.front().starts_with('-')) std::reverse(terms.begin(), terms.end());
  return with_small_fractions(joined_sum(terms));
}

/// Numbers that were given as decimals stay decimals: those whose denominator has a factor 5.
std::optional<std::string> decimal_latex(const RationalFunction& c) {
  if (!c.is_constant()) return std::nullopt;
  const Rational value = c.constant_value();
  if (denominator(value) % 5 != 0 || denominator(value) <= 100) return std::nullopt;
  const std::string decimal = to_decimal(abs(value), 10, Rounding::nearest);
  if (read_rational(decimal) != abs(value)) return std::nullopt;
  return (value < 0 ? "-" : "") + scientific_latex(decimal);
}

/// As short as a decimal as it is as a fraction, a slash counting twice; nothing for numbers that are not decimals.
struct Written {
  std::optional<std::string> decimal;
  std::size_t fraction_size = 0;
};

Written written(const Rational& x) {
  const std::string fraction = to_string(x);
  const std::string decimal = to_decimal(x, 9, Rounding::nearest);
  const bool exact = decimal.find('e') == std::string::npos && read_rational(decimal) == x;
  return {exact ? std::optional(decimal) : std::nullopt, fraction.size() + (fraction.find('/') != std::string::npos)};
}

/// Parameter values: decimals instead of fractions with a large denominator, where that is exact and shorter.
std::vector<std::string> values_latex(const std::vector<Rational>& values) {
  std::size_t decimals = 0, fractions = 0;
  bool large = false, exact = true;
  for (const Rational& x : values) {
    const Written way = written(x);
    exact = exact && way.decimal;
    decimals += way.decimal ? way.decimal->size() : 0;
    fractions += way.fraction_size;
    large = large || denominator(x) >= 50;
  }
  std::vector<std::string> texts;
  for (const Rational& x : values) texts.push_back(large && exact && decimals <= fractions ? *written(x).decimal : inline_latex(x));
  return texts;
}

/// "+\tfrac{w}{2} z^{3}", the sign always written.
std::string signed_term(const RationalFunction& c, const std::string& power, const VariableNames& names) {
  if (c.is_polynomial() && c.numerator().term_count() > 1) {
    const std::string latex = polynomial_latex((Rational(1) / c.denominator().constant_value()) * c.numerator(), names);
    return power.empty() ? (latex.starts_with('-') ? latex : "+" + latex) : fmt::format("+({})\\,{}", latex, power);
  }
  const std::optional<std::string> decimal = decimal_latex(c);
  std::string latex = decimal ? *decimal : to_latex(c, names);
  if (c.is_polynomial()) latex = with_small_fractions(latex);
  const bool negative = latex.starts_with('-');
  if (negative) latex.erase(0, 1);
  if (latex == "1" && !power.empty()) latex.clear();
  return (negative ? "-" : "+") + latex + (latex.empty() || power.empty() ? "" : "\\,") + power;
}

std::string power_latex(const std::string& variable, int exponent) {
  if (exponent == 0) return "";
  return exponent == 1 ? variable : fmt::format("{}^{{{}}}", variable, exponent);
}

}  // namespace

std::string scientific_latex(const std::string& decimal) {
  const std::size_t e = decimal.find('e');
  return e == std::string::npos ? decimal : fmt::format("{}\\cdot10^{{{}}}", decimal.substr(0, e), decimal.substr(e + 1 + (decimal[e + 1] == '+')));
}

std::string inline_latex(const Rational& x) {
  const std::string exact = to_string(x);
  const std::size_t slash = exact.find('/');
  // A long decimal, such as an angle near pi, is written as one.
  if (slash == std::string::npos || exact.size() <= 24) return exact;
  const std::string decimal = to_decimal(x, 17, Rounding::nearest);
  return read_rational(decimal) == x ? decimal : exact;
}

std::string parameter_latex(const std::string& name) { return to_latex(RationalFunction::variable(1, 0), {name}); }

std::string region_latex(const Scheme& scheme, const Box& region) {
  std::string text;
  for (std::size_t k = 0; k < region.size() && k < scheme.parameters.size(); ++k) {
    const Interval& x = region[k];
    if (k > 0) text += ",\\ ";
    text += parameter_latex(scheme.parameters[k].name);
    if (x.is_point()) text += fmt::format("={}", values_latex({x.lower}).front());
    else {
      const std::vector<std::string> ends = values_latex({x.lower, x.upper});
      text += fmt::format("\\in{}{},{}{}", x.lower_open ? "(" : "[", ends[0], ends[1], x.upper_open ? ")" : "]");
    }
  }
  return text;
}

std::string point_latex(const VariableNames& names, std::span<const Rational> point) {
  std::string text;
  for (std::size_t k = 0; k < names.size() && k < point.size(); ++k) {
    text += fmt::format("{}{}={}", k > 0 ? ",\\ " : "", parameter_latex(names[k]), values_latex({point[k]}).front());
  }
  return text;
}

std::string digits_latex(const Interval& number, int digits) {
  if (number.is_point() && to_string(number.lower).size() <= 9) return values_latex({number.lower}).front();
  for (int d = digits; d > 1; --d) {
    const std::string text = to_decimal(number.lower, d, Rounding::nearest);
    if (text == to_decimal(number.upper, d, Rounding::nearest)) return text;
  }
  return fmt::format("[{},{}]", to_decimal(number.lower, 4, Rounding::down), to_decimal(number.upper, 4, Rounding::up));
}

std::vector<std::string> power_sum_terms(const std::vector<std::pair<int, RationalFunction>>& coefficients, const std::string& variable,
                                         const VariableNames& names) {
  std::vector<std::string> terms;
  for (const auto& [exponent, c] : coefficients) {
    if (!c.is_zero()) terms.push_back(signed_term(c, power_latex(variable, exponent), names));
  }
  if (terms.empty()) terms.emplace_back("+0");
  return terms;
}

std::vector<std::string> laurent_terms(const LaurentPolynomial& symbol, const VariableNames& names) {
  std::vector<std::pair<int, RationalFunction>> coefficients;
  for (int i = symbol.is_zero() ? 1 : symbol.lowest(); !symbol.is_zero() && i <= symbol.highest(); ++i) {
    coefficients.emplace_back(i, symbol.coefficient(i));
  }
  return power_sum_terms(coefficients, "z", names);
}

std::vector<std::string> lambda_terms(const LambdaPolynomial& p, const VariableNames& names) {
  std::vector<std::pair<int, RationalFunction>> coefficients;
  for (int s = p.degree(); s >= 0; --s) coefficients.emplace_back(s, RationalFunction(p.coefficients()[static_cast<std::size_t>(s)]));
  return power_sum_terms(coefficients, "\\lambda", names);
}

std::string joined_sum(const std::vector<std::string>& terms) {
  std::string text;
  for (const std::string& term : terms) text += term;
  return text.starts_with('+') ? text.substr(1) : text;
}

Display::Line sum_line(const std::string& left, const std::vector<std::string>& terms) {
  Display::Line line{left, terms};
  std::string& first = line.right.front();
  first = "=" + (first.starts_with('+') ? first.substr(1) : first);
  return line;
}

void close(Display& display, const std::string& mark) { display.lines.back().right.back() += mark; }

std::string sigma_power(int arity, int exponent) {
  const std::string sigma = arity == 2 ? "1+z" : arity == 3 ? "1+z+z^{2}" : fmt::format("1+z+\\dots+z^{{{}}}", arity - 1);
  return exponent == 1 ? fmt::format("({})", sigma) : fmt::format("({})^{{{}}}", sigma, exponent);
}

std::string negative_power(int base, int exponent) { return exponent == 0 ? "1" : fmt::format("{}^{{-{}}}", base, exponent); }

}  // namespace limes
