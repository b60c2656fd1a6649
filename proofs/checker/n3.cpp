// SPDX-License-Identifier: MIT
//
// Theorem N3: let chi be the characteristic polynomial of L(gamma) at one gamma > 0 and one value of the parameters;
// divide out (lambda - 2^{-k}) once for those k = 0..m for which it divides. A root of the rest that is not less than
// 2^{-m} belongs to an eigenvector, to a second one of an eigenvalue 2^{-k}, or to a Jordan chain; since the scheme is
// interpolatory, this is the values at the knots of a limit f with f(t/2) = lambda f(t) (+ c t^k), which no Taylor
// polynomial of degree m with a rest o(t^m) allows.
#include "proofs/checker/certificate.hpp"
#include "proofs/checker/modular.hpp"

namespace limes::checker {

void prove_n3(const Certificate& certificate, Budget& budget) {
  const Rule& rule = *certificate.rule;
  Region point = certificate.leaves.front().region;
  Polynomial denominator = certificate.scheme.denominator;  // with all divisors in the parameters
  for (std::size_t v = 0; v < point.size(); ++v) denominator = substitute(denominator, v, point[v].lower.value, budget);
  if (denominator.empty()) throw Rejected{"denominator", "a denominator of the rule vanishes"};
  point.push_back(certificate.gamma);
  const std::vector<Stencil> rows = matrix_rows(rule, point, budget);

  // det(lambda D - D L) with the product D of the rows' denominators has integer coefficients.
  const auto value = [](const Polynomial& p) { return p.empty() ? mpq_class(0) : p.begin()->second; };
  const std::size_t points = rows.size(), n = 2 * points - 1;
  std::vector<mpz_class> denominators, entries;
  mpz_class bound = 1, leading = 1;
  for (const auto& row : rows) {
    mpz_class common = value(row.denominator).get_den();
    for (const auto& e : row.numerators) {
      budget.work(500 + 8 * limbs(common) * limbs(value(e)));
      common = lcm(common, value(e).get_den());
    }
    denominators.push_back(mpq_class(value(row.denominator) * common).get_num());
    mpz_class sum = abs(denominators.back());
    for (const auto& e : row.numerators) {
      budget.work(500 + 8 * limbs(common) * limbs(value(e)));
      entries.push_back(mpq_class(value(e) * common).get_num());
      sum += abs(entries.back());
    }
    budget.work(8 * limbs(bound) * limbs(sum));
    bound *= 2 * sum;
    leading *= denominators.back();
  }
  const double bits = static_cast<double>(mpz_sizeinbase(bound.get_mpz_t(), 2)) + 2, size = static_cast<double>(n);
  budget.work(moduli_for(bits) * (charpoly_cost(size) + 500 * size + size * size * (30 + bits / 10) + 1e5));
  Reconstruction reconstruction(n + 1, bound + 1);
  for (mpz_class p = next_modulus(); !reconstruction.is_complete(); p = next_modulus(p)) {
    const Modulus f(p);
    std::vector<Residue> matrix(n * n, 0);
    bool usable = true;
    for (std::size_t k = 0; k < points; ++k) {
      const Residue inverse = f.inverse(f.from(denominators[k]));
      usable = usable && inverse != 0;
      for (std::size_t j = 0; j < points; ++j)
        matrix[2 * k * n + k + j] = f.times(f.from(entries[k * points + j]), inverse);
      if (k > 0) matrix[(2 * k - 1) * n + points / 2 - 1 + k] = f.one();
    }
    std::vector<Residue> chi = usable ? characteristic_polynomial(f, std::move(matrix), n) : std::vector<Residue>{};
    for (auto& c : chi) c = f.times(c, f.from(leading));
    if (!chi.empty()) reconstruction.add(f, chi);
  }

  std::vector<mpz_class> rest = reconstruction.result();
  const auto order = static_cast<unsigned long>(certificate.order);
  for (unsigned long k = 0; k <= order; ++k) {  // rest = (2^k lambda - 1) quotient, from the constant term on
    std::vector<mpz_class> quotient;
    mpz_class before = 0;
    for (const auto& c : rest) {
      before = (before << k) - c;
      quotient.push_back(before);
    }
    if (quotient.back() != 0) continue;  // the value at 2^{-k}, times a power of 2 and -1
    quotient.pop_back();
    rest = std::move(quotient);
  }
  for (std::size_t s = 0; s < rest.size(); ++s) rest[s] <<= order * (rest.size() - 1 - s);
  if (all_roots_inside(std::move(rest), budget))
    throw Rejected{"eigenvalue", "all other eigenvalues of L are less than 2^-m at this point"};
}

}  // namespace limes::checker
