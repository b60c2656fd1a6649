#include "analysis/uniform/section_hull.hpp"

#include "algebra/polynomial/bernstein_form.hpp"
#include "analysis/uniform/finite_sections.hpp"

namespace limes {

std::optional<MatrixFamily> section_hull(const LaurentPolynomial& b, const MultivariatePolynomial& denominator, int arity, const Box& box) {
  std::vector<MultivariatePolynomial> polynomials = numerators_over(b, denominator);
  polynomials.push_back(denominator);
  std::vector<int> degrees(box.size(), 0);
  for (const MultivariatePolynomial& p : polynomials) {
    const std::vector<int> own = p.degrees();
    for (std::size_t k = 0; k < box.size(); ++k) degrees[k] = std::max(degrees[k], own[k]);
  }
  std::vector<std::vector<Rational>> forms;
  for (const MultivariatePolynomial& p : polynomials) forms.push_back(BernsteinForm(p, box, degrees).coefficients());
  const std::vector<Rational>& divisor = forms.back();
  const bool positive = std::all_of(divisor.begin(), divisor.end(), [](const Rational& d) { return d > 0; });
  const bool negative = std::all_of(divisor.begin(), divisor.end(), [](const Rational& d) { return d < 0; });
  if (!positive && !negative) return std::nullopt;

  // The index set of b itself, also where an end coefficient vanishes: it stays invariant.
  const int width = b.length() - 1;
  const int size = section_size(width, arity);
  MatrixFamily family;
  for (std::size_t place = 0; place < divisor.size(); ++place) {
    for (int e = 0; e < arity; ++e) {
      RationalMatrix section(size, size);
      for (int i = 0; i < size; ++i) {
        for (int j = 0; j < size; ++j) {
          const int k = e + arity * j - i;
          if (k >= 0 && k <= width) section(i, j) = forms[std::size_t(k)][place] / divisor[place];
        }
      }
      family.push_back(std::move(section));
    }
  }
  return family;
}

}  // namespace limes
