#pragma once

#include "schemes/claim.hpp"
#include "schemes/nonstationary/mask_sequence.hpp"

#include <optional>

namespace limes {

/// One step with the mask a(mu) maps the samples u((l + s) p h), l an integer, of u(y) = y^j e^{i n theta y} to
///
///     sum_{m=0..j} binom(j, m) h^m ((i + s) h)^{j-m} e^{i n theta (i + s) h} M_m,
///     M_m = sum_{k = i mod p} a_k (tau - k)^m E^{n (tau - k)},   E = e^{i theta h},   tau = (p - 1) s.
///
/// So u is reproduced (with parameters i + s) iff M_0 = 1 and M_1 = .. = M_j = 0 for both signs of n and every residue of i, and
/// generated iff these moments do not depend on the residue. With v = n (tau - k) and d the denominator of tau, E^v + E^-v and
/// E^v - E^-v are polynomials in c = cos(theta h / d), the latter times sin(theta h / d); hence the identities in E are those of the
/// even and the odd part in c, mu = T_d(c). Hyperbolic: cosh, sinh, and the same polynomials. [Dyn & Levin 1995]
enum class MomentPart { even, odd };

/// The even part of M_m at a residue; of the odd part, what sin(theta h / d) is multiplied by. In the variable c.
RationalFunction moment(const Mask& mask, const Rational& tau, int residue, int m, int frequency, MomentPart part);

/// A part of a moment that is not what reproduction (generation) needs.
struct MomentDefect {
  int residue = 0;
  int moment = 0;
  MomentPart part = MomentPart::even;
  /// The moment's part less 1 or 0, or for generation less that of residue 0; in the variable c.
  RationalFunction value;
};

/// All defects of a function, in the order of moments; none: it is reproduced (generated) at every angle. \param at_zero only
/// theta = 0 is asked for
std::vector<MomentDefect> defects(const Mask& mask, const Rational& tau, const ExponentialFunction& function,
                                  bool generates, bool at_zero = false);

/// tau = a'(1)/p of the limit mask: the parametrisation that linear functions ask for (0 for a symmetric primal mask).
Rational parameter_tau(const MaskSequence& sequence);
/// The greatest denominator of tau for which frequencies other than 0 are looked at.
constexpr int max_tau_denominator = 16;

/// The functions y^j e^{+-i n theta y}, n <= max_frequency, j <= max_degree, that every step of the scheme reproduces (generates)
/// at every angle.
std::vector<ExponentialFunction> reproduced_space(const MaskSequence& sequence, AngleType type, bool generates,
                                                  int max_degree = 16, int max_frequency = 4);

/// The powers 1, y, .., y^j that every step reproduces at theta = 0, up to max_degree.
std::vector<ExponentialFunction> reproduced_polynomials(const MaskSequence& sequence, int max_degree = 16);

/// For each frequency up to max_frequency the first function that some step does not reproduce (generate) as an identity, with its
/// first defect.
std::vector<std::pair<ExponentialFunction, MomentDefect>> first_failures(const MaskSequence& sequence, AngleType type,
                                                                         bool generates, int max_frequency = 2);

}  // namespace limes
