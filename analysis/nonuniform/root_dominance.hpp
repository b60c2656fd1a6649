#pragma once

#include "algebra/stop.hpp"
#include "analysis/nonuniform/dominance_test.hpp"

#include <string>

namespace limes {

struct RootDominanceOptions {
  /// Tried in this order on every box, the cheap ones first.
  std::vector<DominanceMethod> methods{DominanceMethod::rouche, DominanceMethod::circle, DominanceMethod::boundary,
                                       DominanceMethod::sign_separation};
  int max_boxes = 4096;
  /// Bisections per axis.
  int max_depth = 40;
};

/// What was found about: all roots of r(.; x) lie in |lambda| < rho for every x in the box.
struct RootDominance {
  /// The leaves tile the box, each with a proof.
  bool proved = false;
  std::vector<DominanceLeaf> leaves;
  /// A point of the box at which a root has modulus >= rho, exactly. Then nothing is proved.
  std::optional<std::vector<Rational>> counterexample;
  /// A point of the closed box at which the methods cannot hold, exactly: no bisection helps.
  std::optional<std::vector<Rational>> hopeless_point;
  /// When not proved: why, in words.
  std::string reason;

  int count(DominanceMethod method) const;
};

/// Bisects the box until a method proves dominance on every piece, or a counterexample is found, or the limits are
/// reached.
///
/// Variables whose interval is a point are substituted; then r is divided by the content of its coefficients if that
/// has a proven strict sign on the box (open faces excepted), and its sign is normalised to d_p > 0: see
/// restricted_to(). Open ends of the box belong to faces that the claim excludes (gamma = 0).
/// \pre r has positive degree; the box has one interval for every variable; rho > 0. \throws Interrupted
RootDominance prove_root_dominance(const LambdaPolynomial& r, const Rational& rho, const Box& box,
                                   const RootDominanceOptions& options = {}, const Stop& stop = {});

/// The polynomial that the methods work with on a box: point axes substituted, content divided out where allowed,
/// coprime integer coefficients, d_p > 0 in the middle of the box. Its roots are those of r at every point of the box
/// off its open faces. Nothing when d_p vanishes in the middle.
std::optional<LambdaPolynomial> restricted_to(const LambdaPolynomial& r, const Box& box);

}  // namespace limes
