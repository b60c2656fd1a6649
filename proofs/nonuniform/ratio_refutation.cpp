// Theorem N3: a knot ratio whose eigenvalues are not those of a C^m scheme.

#include "algebra/polynomial/bernstein_form.hpp"
#include "analysis/nonuniform/dominance_test.hpp"
#include "analysis/nonuniform/expanding_eigenvalue.hpp"
#include "analysis/nonuniform/isolated_ratio.hpp"
#include "analysis/nonuniform/split_characteristic_polynomial.hpp"
#include "proofs/nonuniform/knot_proof.hpp"

#include <algorithm>
#include <map>

namespace limes {
namespace {

/// The characteristic polynomial at one ratio without the factors (lambda - 2^{-k}), k <= m, as far as they divide: `rest`.
struct RatioTest {
  Rational gamma;
  LambdaPolynomial rest;
  /// These have no zero: the leading coefficient, and the values at those 2^{-k} that are no eigenvalues.
  std::vector<MultivariatePolynomial> guards;
  /// Where one of these is <= 0, a root has modulus >= 2^{-m}, a real one: the values at 2^{-k}, and at -2^{-k} times
  /// (-1)^degree; any one: the determinant of the boundary test, made when it is needed.
  std::vector<MultivariatePolynomial> values;
  bool has_determinant = false;

  bool has_guards(const Box& box) const {
    return std::all_of(guards.begin(), guards.end(), [&](const MultivariatePolynomial& guard) {
      return BernsteinForm(guard, box).strict_sign_off_open_faces() != 0;
    });
  }
  bool refutes(const Box& box, const std::vector<Rational>& inside) const {
    if (guards.empty() || !has_guards(box) || guards.front()(inside) <= 0) return false;
    return std::any_of(values.begin(), values.end(), [&](const MultivariatePolynomial& value) {
      return value(inside) <= 0 && BernsteinForm(value, box).upper() <= 0;
    });
  }
  void add_determinant(int m) {
    if (has_determinant || values.empty() || rest.degree() < 2) return;
    has_determinant = true;
    values.push_back(boundary_determinant(rest, power(Rational(2), -m)));
  }
};

MultivariatePolynomial value_at(const LambdaPolynomial& p, const Rational& lambda) {
  MultivariatePolynomial result(p.variables());
  for (int s = p.degree(); s >= 0; --s) result = lambda * result + p.coefficients()[static_cast<std::size_t>(s)];
  return result;
}

RatioTest make_test(const LambdaPolynomial& chi, int m, const Box& region, const Rational& gamma) {
  RatioTest test{gamma, chi.substitute(chi.variables() - 1, gamma), {}, {}};
  LambdaPolynomial& rest = test.rest;
  if (rest.degree() < chi.degree()) return test;
  rest = primitive_part(rest).part;
  std::vector<Rational> point = midpoint(region);
  point.push_back(gamma);
  const auto one = MultivariatePolynomial::constant(chi.variables(), 1);
  if (rest.leading()(point) < 0) rest = rest * LambdaPolynomial(chi.variables(), {-one});
  test.guards.push_back(rest.leading());
  for (int k = 0; k <= m; ++k) {
    const Rational eigenvalue = power(Rational(2), -k);
    const MultivariatePolynomial value = value_at(rest, eigenvalue);
    if (value.is_zero()) {
      rest = *exact_quotient(rest, LambdaPolynomial::linear(one, eigenvalue * one));
    } else {
      test.guards.push_back(value);
    }
  }
  for (int k = m; k >= 0; --k) {
    const Rational rho = power(Rational(2), -k);
    test.values.push_back(value_at(rest, rho));
    test.values.push_back(Rational(rest.degree() % 2 == 0 ? 1 : -1) * value_at(rest, -rho));
  }
  return test;
}

class RegionRefutation {
 public:
  RegionRefutation(const LambdaPolynomial& chi, int m, const Box& region, std::vector<Box> pieces,
                   const std::optional<Rational>& first)
      : chi_(chi), m_(m), region_(region), ratios_(candidate_ratios()), waiting_(std::move(pieces)) {
    if (first) ratios_.insert(ratios_.begin(), *first);
  }

  ProofAttempt prove(const ProofLimits& limits, const Stop& stop) {
    ProofAttempt attempt;
    while (!waiting_.empty()) {
      stop.check();
      const Box box = std::move(waiting_.back());
      waiting_.pop_back();
      const auto gamma = ratio_for(box);
      if (gamma) {
        attempt.leaves.push_back({box, RatioWitness{*gamma}});
        continue;
      }
      const int axis = widest_axis(box, region_);
      const bool hopeless = axis < 0 || !ratio_for(point_box(midpoint(box)));
      if (hopeless || static_cast<int>(attempt.leaves.size() + waiting_.size()) + 2 > limits.max_leaves ||
          box[static_cast<std::size_t>(axis)].width() * 1000000 < region_[static_cast<std::size_t>(axis)].width()) {
        attempt.reason = "no knot ratio is found whose eigenvalues contradict the smoothness";
        attempt.failing_point = midpoint(box);
        attempt.leaves.clear();
        return attempt;
      }
      auto [lower, upper] = bisect(box, axis);
      waiting_.push_back(std::move(upper));
      waiting_.push_back(std::move(lower));
    }
    attempt.proved = true;
    return attempt;
  }

 private:
  RatioTest& test(std::size_t k) {
    const auto found = tests_.find(k);
    return found != tests_.end() ? found->second : tests_.emplace(k, make_test(chi_, m_, region_, ratios_[k])).first->second;
  }
  static Box with_ratio(Box box, const Rational& gamma) {
    box.push_back(Interval::point(gamma));
    return box;
  }
  static Box point_box(const std::vector<Rational>& point) {
    Box box;
    for (const Rational& x : point) box.push_back(Interval::point(x));
    return box;
  }
  std::optional<Rational> ratio_for(const Box& box) {
    for (const bool pairs : {false, true}) {
      for (std::size_t k = 0; k < ratios_.size(); ++k) {
        RatioTest& candidate = test(k);
        if (pairs) candidate.add_determinant(m_);
        const Box whole = with_ratio(box, ratios_[k]);
        if (candidate.refutes(whole, midpoint(whole))) return ratios_[k];
      }
    }
    return std::nullopt;
  }

  const LambdaPolynomial& chi_;
  int m_;
  Box region_;
  std::vector<Rational> ratios_;
  std::vector<Box> waiting_;
  std::map<std::size_t, RatioTest> tests_;
};

}  // namespace

ProofAttempt refute_by_ratio(const InsertionRule& rule, int m, const Box& region, const std::optional<Rational>& first,
                             const ProofLimits& limits, const Stop& stop) {
  const LambdaPolynomial chi =
      characteristic_polynomial(SubdivisionMatrix::from_stencils(isolated_ratio_stencils(rule, region)), stop);
  if (!is_point(region)) return RegionRefutation(chi, m, region, pieces_without_poles(rule, region), first).prove(limits, stop);
  ProofAttempt attempt;
  std::optional<ExpandingEigenvalue> found;
  if (first) {
    std::vector<Rational> with_first = midpoint(region);
    with_first.push_back(*first);
    if (chi.leading()(with_first) != 0) found = expanding_eigenvalue_at(chi, m, with_first);
  }
  if (!found) found = find_expanding_eigenvalue(chi, m, region, 1, stop);
  attempt.proved = found.has_value();
  if (found) {
    attempt.leaves.push_back({region, RatioWitness{found->point.back()}});
  } else {
    attempt.reason = "no knot ratio is found whose eigenvalues contradict the smoothness";
    attempt.failing_point = midpoint(region);
  }
  return attempt;
}

}  // namespace limes
