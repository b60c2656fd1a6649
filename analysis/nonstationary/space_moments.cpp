#include "analysis/nonstationary/space_moments.hpp"

#include "algebra/error.hpp"

namespace limes {
namespace {

/// p(T_d(c)).
MultivariatePolynomial at_chebyshev(const MultivariatePolynomial& p, int d) {
  return d == 1 ? p : p.substitute(0, chebyshev_t(d));
}

RationalFunction at_chebyshev(const RationalFunction& f, int d) {
  return d == 1 ? f : RationalFunction(at_chebyshev(f.numerator(), d), at_chebyshev(f.denominator(), d));
}

/// The greatest index of a Chebyshev polynomial: those of a mask of 64 entries with tau of denominator 16, and frequency 4, have less.
constexpr int max_wave = 8192;

int small_integer(const Rational& x) { return numerator(x).convert_to<int>(); }

}  // namespace

RationalFunction moment(const Mask& mask, const Rational& tau, int residue, int m, int frequency, MomentPart part) {
  const LaurentPolynomial& a = mask.symbol;
  const int d = denominator(tau).convert_to<int>();
  RationalFunction sum(1);
  for (int k = a.lowest(); k <= a.highest(); ++k) {
    if ((k - residue) % mask.arity != 0) continue;
    const Rational distance = tau - k;
    if (abs(frequency * d * distance) > max_wave) throw LimitError("the mask is too far from its parametrisation for moments");
    const int v = small_integer(frequency * d * distance);
    MultivariatePolynomial wave = part == MomentPart::even ? chebyshev_t(std::abs(v)) : chebyshev_u(std::abs(v) - 1);
    if (part == MomentPart::odd && v < 0) wave = -wave;
    if (wave.is_zero()) continue;
    sum += at_chebyshev(a.coefficient(k), d) * RationalFunction(power(distance, m) * wave);
  }
  return sum;
}

std::vector<MomentDefect> defects(const Mask& mask, const Rational& tau, const ExponentialFunction& function,
                                  bool generates, bool at_zero) {
  std::vector<MomentDefect> result;
  const RationalFunction one = RationalFunction::constant(1, 1);
  for (int m = 0; m <= function.degree; ++m) {
    for (const MomentPart part : {MomentPart::even, MomentPart::odd}) {
      if (part == MomentPart::odd && (at_zero || function.frequency == 0)) continue;
      RationalFunction wanted(1);
      if (!generates && m == 0 && part == MomentPart::even) wanted = one;
      for (int residue = 0; residue < mask.arity; ++residue) {
        RationalFunction value = moment(mask, tau, residue, m, function.frequency, part);
        if (generates && residue == 0) {
          wanted = value;
          continue;
        }
        value -= wanted;
        if (at_zero) value = value.substitute(0, Rational(1));
        if (!value.is_zero()) result.push_back({residue, m, part, std::move(value)});
      }
    }
  }
  return result;
}

Rational parameter_tau(const MaskSequence& sequence) {
  const LaurentPolynomial limit = limit_mask(sequence, 1).symbol;
  return limit.differentiated()(Rational(1)).constant_value() / sequence.mask.arity;
}

namespace {

bool holds(const MaskSequence& sequence, const Rational& tau, const ExponentialFunction& f, bool generates,
           bool at_zero) {
  for (int k = 0; k <= static_cast<int>(sequence.first_levels.size()); ++k) {
    if (!defects(sequence.at_level(k), tau, f, generates, at_zero).empty()) return false;
  }
  return true;
}

}  // namespace

std::vector<ExponentialFunction> reproduced_space(const MaskSequence& sequence, AngleType type, bool generates,
                                                  int max_degree, int max_frequency) {
  using Wave = ExponentialFunction::Wave;
  const bool hyperbolic = type == AngleType::hyperbolic;
  const Rational tau = parameter_tau(sequence);
  if (denominator(tau) > max_tau_denominator) max_frequency = 0;
  std::vector<ExponentialFunction> space;
  for (int n = 0; n <= max_frequency; ++n) {
    const Wave cosine = n == 0 ? Wave::none : hyperbolic ? Wave::cosh : Wave::cos;
    for (int degree = 0; degree <= max_degree && holds(sequence, tau, {degree, n, cosine}, generates, false);
         ++degree) {
      space.push_back({degree, n, cosine});
      if (n > 0) space.push_back({degree, n, hyperbolic ? Wave::sinh : Wave::sin});
    }
  }
  return space;
}

std::vector<ExponentialFunction> reproduced_polynomials(const MaskSequence& sequence, int max_degree) {
  const Rational tau = parameter_tau(sequence);
  std::vector<ExponentialFunction> space;
  for (int degree = 0; degree <= max_degree; ++degree) {
    const ExponentialFunction power{degree, 0, ExponentialFunction::Wave::none};
    if (!holds(sequence, tau, power, false, true)) break;
    space.push_back(power);
  }
  return space;
}

std::vector<std::pair<ExponentialFunction, MomentDefect>> first_failures(const MaskSequence& sequence, AngleType type,
                                                                         bool generates, int max_frequency) {
  using Wave = ExponentialFunction::Wave;
  const Rational tau = parameter_tau(sequence);
  if (denominator(tau) > max_tau_denominator) max_frequency = 0;
  std::vector<std::pair<ExponentialFunction, MomentDefect>> failures;
  for (int n = 0; n <= max_frequency; ++n) {
    ExponentialFunction f{0, n, n == 0 ? Wave::none : type == AngleType::hyperbolic ? Wave::cosh : Wave::cos};
    while (f.degree < 16 && holds(sequence, tau, f, generates, false)) ++f.degree;
    for (int k = static_cast<int>(sequence.first_levels.size()); k >= 0; --k) {
      std::vector<MomentDefect> found = defects(sequence.at_level(k), tau, f, generates);
      if (found.empty()) continue;
      failures.emplace_back(f, std::move(found.front()));
      break;
    }
  }
  return failures;
}

}  // namespace limes
