#include "analysis/spectral_radius/exact_vectors_impl.hpp"

#include "algebra/error.hpp"

namespace limes {

Rational round_to_bits(const Rational& x, int bits) {
  const Integer doubled = (numerator(x) << unsigned(bits + 1)) + denominator(x), twice = 2 * denominator(x);
  Integer quotient = doubled / twice;
  if (doubled < 0 && quotient * twice != doubled) quotient -= 1;
  return Rational(quotient, Integer(1) << unsigned(bits));
}

Rational modulus_bound(const Rational& x, const Rational& y) {
  if (y == 0) return abs(x);
  constexpr unsigned bits = 64;
  const Rational square = x * x + y * y;
  const Integer root = sqrt(Integer((numerator(square) << (2 * bits)) / denominator(square)));
  return Rational(root + 1, Integer(1) << bits);
}

RationalVector image_of(const RationalMatrix& b, const RationalVector& x) {
  const std::size_t n = std::size_t(b.rows());
  RationalVector result = b * RationalVector(x.begin(), x.begin() + std::ptrdiff_t(n));
  if (x.size() > n) {
    const RationalVector imaginary = b * RationalVector(x.begin() + std::ptrdiff_t(n), x.end());
    result.insert(result.end(), imaginary.begin(), imaginary.end());
  }
  return result;
}

RationalVector unit_vector(int n, int k, const Rational& length) {
  RationalVector result(std::size_t(n), 0);
  result[std::size_t(k)] = length;
  return result;
}

RationalVector remainder(RationalVector x, const SparseCombination& combination, const std::vector<RationalVector>& vectors) {
  // Every vector of one polytope has the same length, and a real x may be a combination of complex ones.
  if (!vectors.empty()) x.resize(std::max(x.size(), vectors.front().size()), 0);
  for (const HullTerm& term : combination) {
    const RationalVector& v = vectors.at(std::size_t(term.index));
    const bool complex = term.im != 0 || term.conjugate;
    if (!complex) {
      for (std::size_t i = 0; i < v.size(); ++i) {
        if (v[i] != 0) x[i] -= term.re * v[i];
      }
      continue;
    }
    const std::size_t n = v.size() / 2;
    for (std::size_t i = 0; i < n; ++i) {
      const Rational imaginary = term.conjugate ? Rational(-v[n + i]) : v[n + i];
      x[i] -= term.re * v[i] - term.im * imaginary;
      x[n + i] -= term.im * v[i] + term.re * imaginary;
    }
  }
  return x;
}

Rational combination_norm(const RationalVector& x, const SparseCombination& combination, const std::vector<RationalVector>& vectors,
                          const Rational& unit) {
  Rational rest = 0, sum = 0;
  for (const Rational& entry : remainder(x, combination, vectors)) rest += abs(entry);
  for (const HullTerm& term : combination) sum += modulus_bound(term.re, term.im);
  return sum + rest / unit;
}

Rational exact_polytope_bound(const Polytope& polytope, const MatrixFamily& family) {
  const int n = family_size(family);
  if (polytope.unit <= 0) throw DomainError("a polytope norm needs a positive unit");
  Rational result = 0;
  for (std::size_t e = 0; e < family.size(); ++e) {
    for (std::size_t i = 0; i < polytope.vectors.size() + std::size_t(n); ++i) {
      const bool is_vector = i < polytope.vectors.size();
      const RationalVector x = is_vector ? polytope.vectors[i] : unit_vector(n, int(i - polytope.vectors.size()), polytope.unit);
      result = std::max(result, combination_norm(image_of(family[e], x), polytope.images.at(e).at(i), polytope.vectors, polytope.unit));
    }
  }
  return result;
}

}  // namespace limes
