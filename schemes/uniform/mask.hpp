#pragma once

#include "algebra/polynomial/laurent_polynomial.hpp"

#include <optional>

namespace limes {

/// The mask a of a uniform stationary scheme of arity p, (S f)_i = sum_j a_{i - p j} f_j, stored as its symbol
/// a(z) = sum_i a_i z^i with coefficients in Q(parameters).
struct Mask {
  int arity = 2;
  LaurentPolynomial symbol;
};

/// The index s with a_s = 1 and a_{s + p k} = 0 for all k != 0 as identities in the parameters, if there is one: then the
/// scheme is interpolatory up to the shift by s.
std::optional<int> interpolatory_index(const Mask& mask);

/// The mask at a parameter value. \throws DomainError at a pole.
Mask at(const Mask& mask, std::span<const Rational> point);

}  // namespace limes
