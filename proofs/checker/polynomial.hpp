// SPDX-License-Identifier: MIT
#pragma once

#include "proofs/checker/interval.hpp"

#include <array>
#include <cstdint>
#include <map>

namespace limes::checker {

constexpr std::size_t max_parameters = 8;
constexpr std::size_t max_variables = 16;  ///< the parameters, and gamma or the ratios of a non-uniform scheme

/// A polynomial over Q in the scheme's parameters, and perhaps others after them: exponents, in the order of the
/// variables, to non-zero coefficients.
using Exponents = std::array<std::uint16_t, max_variables>;
using Polynomial = std::map<Exponents, mpq_class>;

Polynomial constant(const mpq_class& value);
Polynomial variable(std::size_t index);
int degree(const Polynomial& p, std::size_t parameter);
Polynomial add(Polynomial p, const Polynomial& q, Budget& budget);
Polynomial multiply(const Polynomial& p, const Polynomial& q, Budget& budget);
Polynomial substitute(const Polynomial& p, std::size_t parameter, const mpq_class& value, Budget& budget);

/// An uncancelled quotient: the denominator, with leading coefficient 1, vanishes wherever the expression has no value.
struct Fraction {
  Polynomial numerator, denominator = constant(1);
};

Fraction sum(Fraction x, Fraction y, Budget& budget);
Fraction product(const Fraction& x, const Fraction& y, Budget& budget);
/// \pre y is not zero
Fraction quotient(const Fraction& x, const Fraction& y, Budget& budget);
Fraction power(const Fraction& x, int exponent, Budget& budget);

/// A letter, then letters, digits and underscores; at most 64 of them.
bool is_name(std::string_view text);
/// Reads an expression over the parameters. \throws Rejected at the step "scheme" (or "limits")
Fraction read_expression(std::string_view text, const std::vector<std::string>& parameters, Budget& budget);

}  // namespace limes::checker
