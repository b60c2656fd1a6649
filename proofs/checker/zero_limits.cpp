// SPDX-License-Identifier: MIT
//
// Theorem P0: let the sums of the even and of the odd coefficients of a binary mask not both be 1. If S_a^k f tends to a
// continuous F (uniformly, the i-th value to F(2^-k i)), then F = 0: about a point with F(x) != 0 one step multiplies by these sums.
// If in addition a product of sections has a real eigenvalue >= 1, its eigenvector is a window of data that do not tend to
// zero; so S_a has no limit at all for them, and is not C^m for any m.
#include "proofs/checker/projective.hpp"

#include "proofs/checker/theorems.hpp"

namespace limes::checker {
namespace {

/// Whether det(s I - m) <= 0, by fraction-free elimination (Bareiss).
bool determinant_is_not_positive(IntegerMatrix m, std::size_t n, const mpz_class& s, Budget& budget) {
  double size = limbs(s);
  for (auto& x : m) size = std::max(size, limbs(x)), x = -x;
  for (std::size_t i = 0; i < n; ++i) m[i * n + i] += s;
  const auto d = static_cast<double>(n);
  budget.work(d * d * d * (500 + 10 * d * size * d * size));
  budget.hold(d * d * 8 * (d * size + 4));
  mpz_class previous = 1;
  bool negative = false;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && m[pivot * n + k] == 0) ++pivot;
    if (pivot == n) return true;
    if (pivot != k) {
      negative = !negative;
      for (std::size_t j = 0; j < n; ++j) std::swap(m[pivot * n + j], m[k * n + j]);
    }
    for (std::size_t i = k + 1; i < n; ++i)
      for (std::size_t j = k + 1; j < n; ++j) {
        mpz_class& x = m[i * n + j];
        x = x * m[k * n + k] - m[i * n + k] * m[k * n + j];
        mpz_divexact(x.get_mpz_t(), x.get_mpz_t(), previous.get_mpz_t());
      }
    previous = m[k * n + k];
  }
  return (negative ? -m[n * n - 1] : m[n * n - 1]) <= 0;
}

}  // namespace

std::string check_p0(const Json& json, Budget& budget) {
  const MaskClaim claim = read_mask_claim(json, budget);
  const bool only_zero = claim.statement == "only zero limits";
  if (claim.certified ? !only_zero && smoothness_in(claim.statement, "not ") < 0 : smoothness_in(claim.statement, "") < 0)
    throw Rejected{"claim", "theorem P0 certifies \"only zero limits\" and \"not C<m>\" and refutes \"C<m>\""};
  const Reader proof(json.at("proof"), "proof", "the proof",
                     only_zero ? std::vector<std::string>{} : std::vector<std::string>{"word"});

  const Sections& scheme = claim.scheme;
  mpz_class even = 0, odd = 0;
  for (std::size_t k = 0; k < scheme.mask.size(); ++k) (k % 2 == 0 ? even : odd) += scheme.mask[k];
  if (even == scheme.denominator && odd == scheme.denominator)
    throw Rejected{"sums", "the even and the odd coefficients sum to 1"};
  if (only_zero) return "certified: " + checker::quoted(scheme.name) + " has only zero limits (theorem P0)";

  const std::vector<int> word = read_word(proof, "word", 1, 64);
  if (scheme.size < 1) throw Rejected{"scheme", "a mask of one coefficient has no sections"};
  mpz_class scale;
  mpz_pow_ui(scale.get_mpz_t(), scheme.denominator.get_mpz_t(), word.size());
  if (!determinant_is_not_positive(apply_word(scheme, word, budget), scheme.size, scale, budget))
    throw Rejected{"word", "the product of the word is not proved to have a real eigenvalue of at least 1"};
  return mask_statement(claim, "not C0", "P0");
}

}  // namespace limes::checker
