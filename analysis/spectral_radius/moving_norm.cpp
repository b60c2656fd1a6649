// What a moving polytope proves, in exact arithmetic.
#include "algebra/error.hpp"
#include "analysis/spectral_radius/moving_norm_impl.hpp"

namespace limes {

Rational exact_moving_norm(const MovingCombination& combination, const std::array<const RationalMatrix*, 2>& b,
                           const std::array<RationalVector, 2>& x, const std::vector<std::array<RationalVector, 2>>& vectors,
                           const Rational& unit) {
  const std::size_t length = vectors.empty() ? x[0].size() : std::max(x[0].size(), vectors.front()[0].size());
  const auto padded = [&](RationalVector v) {
    v.resize(length, 0);
    return v;
  };
  // 3 times the Bernstein coefficients in degree 3 of the image, then of the remainder.
  std::array<RationalVector, 4> rest;
  {
    std::array<RationalVector, 2> same, mixed;
    for (std::size_t k : {0, 1}) {
      same[k] = padded(image_of(*b[k], x[k]));
      mixed[k] = padded(image_of(*b[k], x[1 - k]));
    }
    for (auto& r : rest) r.assign(length, 0);
    for (std::size_t i = 0; i < length; ++i) {
      const Rational middle = mixed[0][i] + mixed[1][i];
      rest[0][i] = 3 * same[0][i];
      rest[1][i] = same[0][i] + middle;
      rest[2][i] = middle + same[1][i];
      rest[3][i] = 3 * same[1][i];
    }
  }
  const auto subtract = [&](RationalVector& r, int factor, const MovingTerm& term, std::size_t k, std::size_t place) {
    const RationalVector& v = vectors.at(std::size_t(term.index))[place];
    const Rational re = factor * term.re[k], im = factor * term.im[k];
    const std::size_t n = length == v.size() && (term.conjugate || im != 0 || length > std::size_t(b[0]->rows())) ? v.size() / 2 : v.size();
    if (n == v.size()) {
      for (std::size_t i = 0; i < n; ++i) r[i] -= re * v[i];
      return;
    }
    for (std::size_t i = 0; i < n; ++i) {
      const Rational imaginary = term.conjugate ? Rational(-v[n + i]) : v[n + i];
      r[i] -= re * v[i] - im * imaginary;
      r[n + i] -= im * v[i] + re * imaginary;
    }
  };
  std::array<Rational, 3> sums{0, 0, 0};
  for (const MovingTerm& term : combination) {
    for (std::size_t k = 0; k < 3; ++k) sums[k] += modulus_bound(term.re[k], term.im[k]);
    subtract(rest[0], 3, term, 0, 0);
    subtract(rest[1], 1, term, 0, 1);
    subtract(rest[1], 2, term, 1, 0);
    subtract(rest[2], 2, term, 1, 1);
    subtract(rest[2], 1, term, 2, 0);
    subtract(rest[3], 3, term, 2, 1);
  }
  const std::array<Rational, 4> norms = elevated(sums);
  Rational result = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    Rational size = 0;
    for (const Rational& entry : rest[k]) size += abs(entry);
    result = std::max(result, Rational(norms[k] + size / (3 * unit)));
  }
  return result;
}

Rational exact_moving_bound(const MovingPolytope& polytope, const MatrixFamily& ends) {
  const int n = family_size(ends);
  if (polytope.unit <= 0) throw DomainError("a polytope norm needs a positive unit");
  const std::size_t letters = ends.size() / 2;
  Rational result = 0;
  for (std::size_t e = 0; e < letters; ++e) {
    for (std::size_t i = 0; i < polytope.vectors.size() + std::size_t(n); ++i) {
      std::array<RationalVector, 2> x;
      if (i < polytope.vectors.size()) x = polytope.vectors[i];
      else x[0] = x[1] = unit_vector(n, int(i - polytope.vectors.size()), polytope.unit);
      result = std::max(result, exact_moving_norm(polytope.images.at(e).at(i), {&ends[e], &ends[letters + e]}, x,
                                                                polytope.vectors, polytope.unit));
    }
  }
  return result;
}

}  // namespace limes
