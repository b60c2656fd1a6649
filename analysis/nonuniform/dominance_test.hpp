#pragma once

#include "algebra/polynomial/box.hpp"
#include "algebra/stop.hpp"
#include "analysis/nonuniform/lambda_polynomial.hpp"

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace limes {

/// Four sufficient conditions for: all roots of r(.; x) lie in |lambda| < rho for every x of a box.
enum class DominanceMethod { rouche, boundary, circle, sign_separation };

std::string_view to_string(DominanceMethod method);
std::optional<DominanceMethod> dominance_method_from(std::string_view text);

/// A box on which one method proves dominance, with what a second program needs to repeat the proof.
struct DominanceLeaf {
  Box box;
  DominanceMethod method = DominanceMethod::rouche;
  /// boundary, circle: a point of the box at which all roots are inside, and which the proof continues to the whole
  /// box.
  std::vector<Rational> sample;
  /// circle: -1 = c_0 < .. < c_k = 1; the Bernstein coefficients of F on [c_{i-1}, c_i] x box are positive for every i.
  std::vector<Rational> cuts;
  /// sign_separation: ascending intervals with at most end points in common; r has opposite strict signs at the two
  /// ends of each, on the whole box (off open faces).
  std::vector<Interval> roots;
};

/// One method for one polynomial r and one rho. The r given to the constructors below has a d_p that is positive
/// somewhere in the boxes asked for, and its variables are those of the boxes.
///
/// "Positive on the box" means: strictly positive Bernstein coefficients on the closed box, or, with `open faces`,
/// after a product of powers of the distances to faces that the box excludes has been divided out.
class DominanceTest {
 public:
  virtual ~DominanceTest() = default;
  virtual DominanceMethod method() const = 0;
  /// A leaf when dominance is proved on the whole box. \param sample a point of the box off its open faces at which r
  /// has its full degree and all roots are inside
  virtual std::optional<DominanceLeaf> prove(const Box& box, const std::vector<Rational>& sample) const = 0;
  /// Whether no box that has this point, on an open face or not, can ever be proved by this method. False says nothing.
  virtual bool is_hopeless_at(const std::vector<Rational>& point) const;
};

/// Coefficient Rouche test: in the least common multidegree of all d_s, sum_{s<p} |d^s_I| rho^s < d^p_I rho^p for every
/// I. Then |r(z) - d_p z^p| < |d_p z^p| on |z| = rho. Sound on the closed box. [Karciauskas & Peters 2013, eq. (16)]
std::unique_ptr<DominanceTest> make_rouche_test(const LambdaPolynomial& r, const Rational& rho);

/// Boundary test: with s(z) = r(rho z), s(1), (-1)^p s(-1) and D are positive on the box (open faces). D = det(X - Y)
/// with X_ij = s_{p-j+i} (j >= i), Y_ij = s_{i+j-p} (i+j >= p), 1 <= i, j < p, is s_p^{p-1} prod_{i<j} (1 - z_i z_j)
/// for the roots z_i of s; a root that leaves the unit disc makes one of the three vanish.
std::unique_ptr<DominanceTest> make_boundary_test(const LambdaPolynomial& r, const Rational& rho);

/// Circle test: F(c, x) = |r(rho e^{it}; x)|^2, c = cos t, is positive on [-1, 1] x closed box: no root ever meets the
/// circle.
std::unique_ptr<DominanceTest> make_circle_test(const LambdaPolynomial& r, const Rational& rho);

/// Sign separation: q >= p - 2 disjoint intervals [a_k, b_k] in [-rho, rho] at whose ends r has opposite signs on the
/// box (open faces). If q = p, all roots are real and inside. Otherwise, in addition: (i) in r(rho + u) and (-1)^p
/// r(-rho - u) the coefficient of u^0 is positive on the box (open faces) and the others have no negative Bernstein
/// coefficient: no real root has modulus >= rho; (iii) no interval contains 0 and |d_0| < rho^2 d_p prod_k min(|a_k|,
/// |b_k|) on the closed box: nor has a pair of conjugate roots.
/// [Karciauskas & Peters 2013, Props. 2 and 5]
std::unique_ptr<DominanceTest> make_sign_separation_test(const LambdaPolynomial& r, const Rational& rho);

/// D of the boundary test, in the variables of r; 1 for p = 1. \pre p >= 1
MultivariatePolynomial boundary_determinant(const LambdaPolynomial& r, const Rational& rho, const Stop& stop = {});
/// F of the circle test in the variables of r, then c: F = sum_i s_i^2 + 2 sum_{k>=1} T_k(c) sum_i s_i s_{i+k} for s(z)
/// = r(rho z).
MultivariatePolynomial circle_polynomial(const LambdaPolynomial& r, const Rational& rho);

}  // namespace limes
