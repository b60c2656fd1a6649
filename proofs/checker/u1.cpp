// SPDX-License-Identifier: MIT
//
// Theorem U1 (Dyn 1992; Dyn & Levin, Acta Numerica 2002): let a(1) = p and a(z) = sigma(z)^{m+1} p^{-m} b(z) up to a
// shift. If ||S_b^l|| = max_r sum_{j = r mod p^l} |b^{[l]}_j| < 1 for some l, b^{[l]}(z) = b(z) b(z^p) ...
// b(z^{p^{l-1}}), then S_a is C^m.
#include "proofs/checker/certificate.hpp"

#include <algorithm>
#include <cmath>

namespace limes::checker {

double norm_work(const LocalScheme& scheme, int level) {
  if (!scheme.has_factor || scheme.quotient.count() == 0) return 0;  // the proof fails before it works
  const Bernstein& b = scheme.quotient;
  mpz_class sum = 1;
  for (const auto& c : b.coefficients) sum += abs(c);
  for (const auto& c : scheme.denominator.coefficients) sum += abs(c);
  // Sums of absolute values are submultiplicative: this one bounds the bits of the coefficients of B^{[k]} and D^k.
  const double bits = static_cast<double>(mpz_sizeinbase(sum.get_mpz_t(), 2)), n = static_cast<double>(b.count());
  double work = 0, length = n;
  for (int k = 1; k < level; ++k) {
    work += length * tensor_size(b.degrees, k) * n * tensor_size(b.degrees, 1) * cost(k * bits / 64 + 1, bits / 64 + 1);
    length = scheme.arity * (length - 1) + n;
  }
  const double entries = length * tensor_size(b.degrees, level), size = level * bits / 64 + 1;
  if (!(entries * 1.5 * (32 + 8 * size) <= 512e6)) throw Rejected{"limits", "the level needs too much memory"};
  return work + entries * (100 + size);
}

void prove_symbol(const LocalScheme& scheme) {
  for (std::size_t i = 0, stride = scheme.mask.size(); i < stride; ++i) {
    mpz_class sum = 0;
    for (std::size_t j = 0; j < scheme.mask.count(); ++j) sum += scheme.mask.coefficients[j * stride + i];
    if (sum != scheme.arity * scheme.denominator.coefficients[i])
      throw Rejected{"sum", "the mask does not sum to the arity"};
  }
  if (!scheme.has_factor) throw Rejected{"factor", "sigma^(m+1) does not divide the symbol"};
}

void prove_norm(const LocalScheme& scheme, int level) {
  Bernstein iterated = scheme.quotient;  // B^{[k+1]}(z) = B(z) B^{[k]}(z^p)
  for (int k = 1; k < level; ++k)
    iterated = convolve(scheme.quotient, iterated, static_cast<std::size_t>(scheme.arity));
  const Bernstein bound = power(scheme.denominator, level);

  // The residues 0, .., p^l - 1; from the length of B^{[l]} on they have no entries, so one of these stands for all.
  const std::size_t count = iterated.count(), size = iterated.size();
  const double modulus = std::pow(scheme.arity, level);
  const std::size_t period = modulus > static_cast<double>(count) ? count + 1 : static_cast<std::size_t>(modulus);
  for (std::size_t residue = 0; residue < period; ++residue) {
    std::vector<mpz_class> gap = bound.coefficients;
    for (std::size_t j = residue; j < count; j += period)
      for (std::size_t i = 0; i < size; ++i) gap[i] -= abs(iterated.coefficients[j * size + i]);
    if (!is_positive(gap, bound.degrees, scheme.box))
      throw Rejected{"contractivity", "the norm of level " + std::to_string(level) + " is not proved below 1"};
  }
}

}  // namespace limes::checker
