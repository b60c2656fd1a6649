#pragma once

#include "analysis/nonuniform/lambda_polynomial.hpp"
#include "reports/document/document.hpp"
#include "schemes/scheme.hpp"

namespace limes {

/// LaTeX of what proofs speak about. `inline_latex` uses a slash for fractions.

std::string inline_latex(const Rational& x);
/// "8.3e-8" as "8.3\cdot10^{-8}".
std::string scientific_latex(const std::string& decimal);
/// "w \in (0, 21/500],\ \mu = 1", empty without parameters. Ends are exact: decimals where those are shorter, "w \in [0.0141, 0.015]".
std::string region_latex(const Scheme& scheme, const Box& region);
std::string parameter_latex(const std::string& name);
/// "w = 1/16, \mu = 2"
std::string point_latex(const VariableNames& names, std::span<const Rational> point);

/// An enclosure by its right digits, "0.4097351", or its ends when there are none.
std::string digits_latex(const Interval& number, int digits = 10);

/// sum_k c_k x^k, one text per term with its sign in front: terms of the display below.
std::vector<std::string> power_sum_terms(const std::vector<std::pair<int, RationalFunction>>& coefficients, const std::string& variable,
                                         const VariableNames& names);
std::vector<std::string> laurent_terms(const LaurentPolynomial& symbol, const VariableNames& names);
std::vector<std::string> lambda_terms(const LambdaPolynomial& p, const VariableNames& names);

/// left = the sum of the terms.
Display::Line sum_line(const std::string& left, const std::vector<std::string>& terms);
/// A mark at the end of the last line.
void close(Display& display, const std::string& mark);
std::string joined_sum(const std::vector<std::string>& terms);

/// (1+z)^k, (1+z+z^2)^k, .., with the exponent left out when it is 1.
std::string sigma_power(int arity, int exponent);
/// 2^{-k}, 1 for k = 0; 1/2 and the like are left as powers.
std::string negative_power(int base, int exponent);

}  // namespace limes
