// Theorem N3 at one parameter value: a knot ratio whose eigenvalues are not those of a C^m scheme.

#include "analysis/nonuniform/expanding_eigenvalue.hpp"
#include "analysis/nonuniform/isolated_ratio.hpp"
#include "analysis/nonuniform/split_characteristic_polynomial.hpp"
#include "proofs/nonuniform/knot_proof.hpp"

namespace limes {

ProofAttempt refute_by_ratio(const InsertionRule& rule, int m, const std::vector<Rational>& point,
                             const std::optional<Rational>& first, const Stop& stop) {
  ProofAttempt attempt;
  Box region;
  for (const Rational& x : point) region.push_back(Interval::point(x));
  const LambdaPolynomial chi =
      characteristic_polynomial(SubdivisionMatrix::from_stencils(isolated_ratio_stencils(rule, region)), stop);
  std::optional<ExpandingEigenvalue> found;
  if (first) {
    std::vector<Rational> with_first = point;
    with_first.push_back(*first);
    if (chi.leading()(with_first) != 0) found = expanding_eigenvalue_at(chi, m, with_first);
  }
  if (!found) found = find_expanding_eigenvalue(chi, m, region, 1, stop);
  attempt.proved = found.has_value();
  if (found) {
    attempt.leaves.push_back({region, RatioWitness{found->point.back()}});
  } else {
    attempt.reason = "no knot ratio is found whose eigenvalues contradict the smoothness";
    attempt.failing_point = point;
  }
  return attempt;
}

}  // namespace limes
