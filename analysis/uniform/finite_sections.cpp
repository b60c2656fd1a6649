#include "analysis/uniform/finite_sections.hpp"

#include "algebra/error.hpp"

namespace limes {

int section_size(int degree, int arity) { return std::max(1, (degree + arity - 2) / (arity - 1)); }

FiniteSections::FiniteSections(const LaurentPolynomial& b, int arity) : FiniteSections(b, common_denominator(b), arity) {}

FiniteSections::FiniteSections(const LaurentPolynomial& b, MultivariatePolynomial denominator, int arity)
    : arity_(arity), size_(0), denominator_(std::move(denominator)) {
  if (b.is_zero() || arity < 2) throw DomainError("FiniteSections: needs a non-zero symbol and arity >= 2");
  const int n = b.length() - 1;
  size_ = section_size(n, arity);
  const std::vector<MultivariatePolynomial> entries = numerators_over(b, denominator_);
  for (int e = 0; e < arity; ++e) {
    PolynomialMatrix section(b.variables(), size_, size_);
    for (int i = 0; i < size_; ++i) {
      for (int j = -n; j <= size_ + n; ++j) {
        const int k = e + arity * j - i;
        if (k < 0 || k > n || entries[k].is_zero()) continue;
        if (j < 0 || j >= size_) throw InternalError("FiniteSections: the index set is not invariant");
        section(i, j) = entries[k];
      }
    }
    numerators_.push_back(std::move(section));
  }
}

RationalMatrix FiniteSections::product(const std::vector<int>& word, std::span<const Rational> point) const {
  const Rational d = denominator_(point);
  if (d == 0) throw DomainError("FiniteSections: a pole of the mask");
  RationalMatrix result = RationalMatrix::identity(size_);
  for (const int e : word) result = result * numerators_[e].at(point);
  const Rational scale = 1 / power(d, static_cast<int>(word.size()));
  for (int i = 0; i < size_; ++i) {
    for (int j = 0; j < size_; ++j) result(i, j) *= scale;
  }
  return result;
}

}  // namespace limes
