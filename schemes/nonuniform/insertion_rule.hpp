#pragma once

#include "algebra/expression/expression.hpp"
#include "schemes/nonuniform/bezier_segment.hpp"
#include "schemes/nonuniform/knot_ratios.hpp"
#include "schemes/uniform/mask.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace limes {

struct RuleProgram;

/// An insertion rule as a scheme file writes it down: `let` and exactly one of `new_point` and `coefficients`.
struct InsertionRuleText {
  struct Line {
    std::string text;
    /// Line of the scheme file, 0 when unknown; errors carry it.
    int line = 0;
  };
  struct Definition {
    std::string name;
    Line value;
  };
  /// 2n; 0: the least even number that suffices for new_point.
  int points = 0;
  std::vector<Definition> let;
  Line new_point;
  std::vector<Line> coefficients;
};

/// The rule of a binary interpolatory 2n-point scheme over non-uniform knots: the new point at (t_i + t_{i+1})/2 is
/// sum_{j=1..2n} e_j p_{i-n+j}, and the stencil e_1 .. e_2n depends on the knots t_{i-n+1} .. t_{i+n}. It is rational
/// in the knots and in the parameters, and invariant under affine maps of the knots.
///
/// A rule is an expression over the following vocabulary. Segments live on the interval [t_i, t_{i+1}], u in [0, 1], in
/// Bezier form [Karciauskas & Peters 2013, section 2]; the right column says by which functions of the knots they
/// divide, besides their arguments.
///
///     segment
///       f(k, j)           the polynomial of degree k that interpolates p_{i+j-floor(k/2)+s} at       t_b - t_a, a < b,
///                         t_{i+j-floor(k/2)+s}, s = 0..k                                             of its knots
///       hermite(r, A, B)  degree 2r+1, with the r-jet of A at 0 and that of B at 1                   nothing
///       degree(d, S)      S in degree d (degree raising)                                             nothing
///       tension(c, S)     S of degree 2r+1 with u scaled by c in the r-jets of both ends             nothing
///       join(r, S)        S made C^r at the knots, r <= 3, from S on the intervals i-1, i, i+1, by   t_{k+1} - t_k,
///                         eqs. (3)-(5): r = 1 moves the end points, r = 2, 3 the r-1-st              t_{k+1} - t_{k-1}
///                         coefficient from each end; C^r if S is C^{r-2}
///       split(r, S)       the C^r segment of r+1 pieces of degree r+1 with the r-jets of S           nothing
///       split(r, S, p)    the same in p pieces, where they suffice for the degree of S:
///                         split(2, S, 2) for a quartic S
///       combinations      A + B, A - B, c*A, A/c of segments of equal degree and pieces              nothing
///     point
///       at(S, u)          the value of S at the rational number u                                    nothing
///       dot([c0, ..], S)  sum of c_j times coefficient j of the segment S, which is in one piece     nothing
///       again(E)          E once more, on the knots .., t_{i-1/2}, t_i, t_{i+1}, t_{i+3/2}, ..       sums of halves of
///                         and the points that E itself inserts at the half ones                      intervals
///       combinations      A + B, A - B, c*A, A/c
///     number c            an expression in the parameters                                            parameters only
///
/// So every division by a function of the knots is a division by a sum of intervals with non-negative weights: the
/// stencil has no pole at strictly increasing knots, whatever their ratios. This holds for every rule that the
/// constructor accepts.
class InsertionRule {
 public:
  /// \throws InputError with line and column: an expression that does not parse, an unknown name or function, a wrong
  /// number or kind of arguments, a cycle of definitions, points that are not even or do not suffice; for
  /// `coefficients`: not 2n of them, or a denominator that is not (polynomial in the parameters) * (polynomial in the
  /// ratios with coefficients of one sign).
  InsertionRule(const InsertionRuleText& text, const VariableNames& parameters);
  /// The rule of one expression, for as many points as it needs.
  InsertionRule(const Expression& new_point, const VariableNames& parameters);

  /// 2n
  int points() const;
  int parameters() const;
  const VariableNames& parameter_names() const;
  const InsertionRuleText& text() const;

  /// e_1 .. e_2n for knots t_{i-n+1} .. t_{i+n} that are functions in any common set of variables, of which the first
  /// ones are the parameters: (parameters, gamma), (parameters, b1 .. b{2n-2}), ...
  /// \pre 2n knots, different as functions \throws DomainError for another number of knots or variables
  std::vector<RationalFunction> stencil(std::span<const RationalFunction> knots) const;
  /// The same at rational knots and parameter values. \pre strictly increasing knots \throws DomainError at a pole in
  /// the parameters.
  std::vector<Rational> stencil(std::span<const Rational> knots, std::span<const Rational> parameter_values) const;
  /// The same in floating point. \pre strictly increasing, finite knots
  std::vector<double> approx_stencil(std::span<const double> knots, std::span<const double> parameter_values) const;
  /// For independent ratios; variables: the parameters, then b1 .. b{2n-2}. Takes milliseconds for 2n <= 8 and
  /// a fraction of a second for 2n = 10.
  std::vector<RationalFunction> symbolic_stencil() const;
  /// For equal intervals; variables: the parameters.
  std::vector<RationalFunction> uniform_stencil() const;

  /// The coefficients of a defined segment on the interval [t_{i+shift}, t_{i+shift+1}], knots and points as in
  /// stencil().
  /// \throws DomainError when there is no segment of that name, or it needs points beyond the 2n.
  BezierSegment<RationalFunction> segment(const std::string& name, std::span<const RationalFunction> knots,
                                          int shift = 0) const;
  BezierSegment<Rational> segment(const std::string& name, std::span<const Rational> knots,
                                  std::span<const Rational> parameter_values, int shift = 0) const;

  /// Every division by a function of the knots is by t(to) - t(from) with one of these 0 <= from < to <= 2n-1, t(x)
  /// piecewise linear with t(k) = t_{i-n+1+k}. Empty for rules given by coefficients.
  struct Divisor {
    Rational from, to;
    auto operator<=>(const Divisor&) const = default;
  };
  std::vector<Divisor> divisors() const;
  /// The different, non-constant denominators of the numbers in the rule: polynomials in the parameters. The stencil
  /// has no pole where none of them vanishes, whatever the ratios.
  std::vector<MultivariatePolynomial> parameter_denominators() const;

 private:
  std::shared_ptr<const RuleProgram> program_;
};

/// The mask of the rule for equal intervals: a_0 = 1 and a_{1-2o} the weight of p_{i+o}.
Mask uniform_mask(const InsertionRule& rule);

}  // namespace limes
