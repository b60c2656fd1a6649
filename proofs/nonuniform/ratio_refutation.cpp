// Theorem N3: a knot ratio whose eigenvalues are not those of a C^m scheme.

#include "algebra/polynomial/bernstein_form.hpp"
#include "algebra/polynomial/schur_cohn.hpp"
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
  /// Where one of these is <= 0, a root has modulus >= 2^{-m}: a real one by the values at 2^{-k}, and at -2^{-k} times
  /// (-1)^degree; a real one or a complex pair by the determinant of the boundary test, made when it is needed.
  std::vector<MultivariatePolynomial> values;
  /// Where one of these is not 0, t^k is no eigenvector to an eigenvalue 2^{-k}, k <= m.
  std::vector<MultivariatePolynomial> defects;
  bool has_determinant = false;

  bool has_guards(const Box& box) const {
    return !guards.empty() && std::all_of(guards.begin(), guards.end(), [&](const MultivariatePolynomial& guard) {
      return BernsteinForm(guard, box).strict_sign_off_open_faces() != 0;
    });
  }
  /// Whether one of `values` is <= 0 on the box. \param points of its closure: exact numbers are cheaper than polynomials
  bool refutes(const Box& box, const std::vector<std::vector<Rational>>& points) const {
    if (guards.empty() || guards.front()(points.front()) <= 0) return false;
    std::optional<bool> guarded;
    for (const MultivariatePolynomial& defect : defects) {
      if (BernsteinForm(defect, box).strict_sign_off_open_faces() == 0) continue;
      if (!guarded) guarded = has_guards(box);
      if (*guarded) return true;
    }
    for (const MultivariatePolynomial& value : values) {
      if (std::any_of(points.begin(), points.end(), [&](const auto& point) { return value(point) > 0; })) continue;
      if (BernsteinForm(value, box).upper() > 0) continue;
      if (!guarded) guarded = has_guards(box);
      if (*guarded) return true;
    }
    return false;
  }
  /// Whether at each of the points some root has modulus >= 2^{-m}.
  bool may_refute_by_pairs(const std::vector<std::vector<Rational>>& points, int m) const {
    if (guards.empty() || rest.degree() < 2) return false;
    return std::all_of(points.begin(), points.end(), [&](const auto& point) {
      const Polynomial at = rest.at(point);
      return at.degree() == rest.degree() && !roots_inside_circle(at, power(Rational(2), -m));
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

RatioTest make_test(const SubdivisionMatrix& matrix, const LambdaPolynomial& chi, int m, const Box& region, const Rational& gamma) {
  RatioTest test{gamma, chi.substitute(chi.variables() - 1, gamma), {}, {}, {}};
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
      for (const MultivariatePolynomial& defect : matrix.power_defects(k)) {
        const MultivariatePolynomial at_ratio = defect.substitute(matrix.gamma(), gamma);
        if (!at_ratio.is_zero()) test.defects.push_back(at_ratio);
      }
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
  /// \param symmetric the eigenvalues for 1/gamma are those for gamma
  RegionRefutation(const SubdivisionMatrix& matrix, const LambdaPolynomial& chi, int m, const Box& region, std::vector<Box> pieces, bool symmetric,
                   const std::optional<Rational>& first)
      : matrix_(matrix), chi_(chi), m_(m), region_(region), ratios_(candidate_ratios()), waiting_(std::move(pieces)) {
    // The claim may fail for very small or very large ratios only.
    for (int k = 16; k <= 40; k += 4) {
      for (const int sign : {-1, 1}) ratios_.push_back(power(Rational(2), sign * k));
    }
    if (symmetric) std::erase_if(ratios_, [](const Rational& gamma) { return gamma > 1; });
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
    return found != tests_.end() ? found->second : tests_.emplace(k, make_test(matrix_, chi_, m_, region_, ratios_[k])).first->second;
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
  /// The middle first, then the corners of the closure.
  static std::vector<std::vector<Rational>> points_of(const Box& box) {
    std::vector<std::vector<Rational>> points{midpoint(box)};
    if (is_point(box) || box.size() > 4) return points;
    for (unsigned corner = 0; corner < 1u << box.size(); ++corner) {
      std::vector<Rational> point;
      for (std::size_t k = 0; k < box.size(); ++k) point.push_back((corner >> k & 1u) != 0 ? box[k].upper : box[k].lower);
      if (std::find(points.begin(), points.end(), point) == points.end()) points.push_back(std::move(point));
    }
    return points;
  }
  std::optional<Rational> ratio_for(const Box& box) {
    constexpr int max_determinants = 3;
    int determinants = 0;
    for (const bool pairs : {false, true}) {
      for (std::size_t k = 0; k < ratios_.size(); ++k) {
        RatioTest& candidate = test(k);
        const Box whole = with_ratio(box, ratios_[k]);
        const std::vector<std::vector<Rational>> points = points_of(whole);
        if (pairs) {
          if (determinants == max_determinants) return std::nullopt;
          if (!candidate.may_refute_by_pairs(points, m_)) continue;
          ++determinants;
          candidate.add_determinant(m_);
        }
        if (candidate.refutes(whole, points)) return ratios_[k];
      }
    }
    return std::nullopt;
  }

  const SubdivisionMatrix& matrix_;
  const LambdaPolynomial& chi_;
  int m_;
  Box region_;
  std::vector<Rational> ratios_;
  std::vector<Box> waiting_;
  std::map<std::size_t, RatioTest> tests_;
};

/// A ratio at which some 2^{-k}, k <= m, is an eigenvalue and t^k no eigenvector to it, at one parameter value.
std::optional<Rational> ratio_with_other_eigenvector(const SubdivisionMatrix& matrix, const LambdaPolynomial& chi, int m, const Box& region) {
  std::vector<Rational> point = midpoint(region);
  point.emplace_back();
  for (int k = 0; k <= m; ++k) {
    const std::vector<MultivariatePolynomial> defects = matrix.power_defects(k);
    for (const Rational& gamma : candidate_ratios()) {
      point.back() = gamma;
      if (chi.leading()(point) == 0 || chi.at(point)(power(Rational(2), -k)) != 0) continue;
      if (std::any_of(defects.begin(), defects.end(), [&](const auto& defect) { return defect(point) != 0; })) return gamma;
    }
  }
  return std::nullopt;
}

}  // namespace

ProofAttempt refute_by_ratio(const InsertionRule& rule, int m, const Box& region, const std::optional<Rational>& first,
                             const ProofLimits& limits, const Stop& stop) {
  const std::vector<std::vector<RationalFunction>> stencils = isolated_ratio_stencils(rule, region);
  const SubdivisionMatrix matrix = SubdivisionMatrix::from_stencils(stencils);
  const LambdaPolynomial chi = characteristic_polynomial(matrix, stop);
  if (!is_point(region)) {
    return RegionRefutation(matrix, chi, m, region, pieces_without_poles(rule, region), is_mirror_symmetric(stencils), first).prove(limits, stop);
  }
  ProofAttempt attempt;
  std::optional<ExpandingEigenvalue> found;
  if (first) {
    std::vector<Rational> with_first = midpoint(region);
    with_first.push_back(*first);
    if (chi.leading()(with_first) != 0) found = expanding_eigenvalue_at(chi, m, with_first);
  }
  if (!found) found = find_expanding_eigenvalue(chi, m, region, 1, stop);
  const std::optional<Rational> ratio = found ? found->point.back() : ratio_with_other_eigenvector(matrix, chi, m, region);
  attempt.proved = ratio.has_value();
  if (ratio) {
    attempt.leaves.push_back({region, RatioWitness{*ratio}});
  } else {
    attempt.reason = "no knot ratio is found whose eigenvalues contradict the smoothness";
    attempt.failing_point = midpoint(region);
  }
  return attempt;
}

}  // namespace limes
