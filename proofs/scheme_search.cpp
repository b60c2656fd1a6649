#include "proofs/scheme_search.hpp"

#include "algebra/error.hpp"
#include "analysis/nonuniform/nelder_mead.hpp"
#include "proofs/prove.hpp"

#include <cmath>
#include <random>

namespace limes {
namespace {

constexpr int iterations = 200;

/// A distance from the box counts as much as a radius: the search stays inside.
class Objective {
 public:
  Objective(const SpectrumScreen& screen, const Box& box, const Stop& stop) : screen_(screen), stop_(stop) {
    for (const Interval& interval : box) ends_.push_back({approx_double(interval.lower), approx_double(interval.upper)});
  }

  /// The mean of the radii^p, to the power 1/p; their maximum for p = 0.
  double operator()(std::span<const double> x, int p) const {
    stop_.check();
    std::vector<double> inside(x.begin(), x.end());
    double outside = 0;
    for (std::size_t k = 0; k < inside.size(); ++k) {
      inside[k] = std::clamp(inside[k], ends_[k].first, ends_[k].second);
      outside += std::abs(x[k] - inside[k]);
    }
    double sum = 0, greatest = 0;
    const std::vector<double> radii = screen_.approx_radii(inside);
    for (const double radius : radii) {
      greatest = std::max(greatest, radius);
      if (p > 0) sum += std::pow(std::min(radius, 1e3), p);
    }
    return outside + (p > 0 ? std::pow(sum / double(radii.size()), 1.0 / p) : greatest);
  }

 private:
  const SpectrumScreen& screen_;
  const Stop& stop_;
  std::vector<std::pair<double, double>> ends_;
};

/// In a randomly scaled copy of the box about its middle.
std::vector<double> random_start(const Box& box, unsigned seed, int start) {
  std::seed_seq sequence{seed, static_cast<unsigned>(start)};
  std::mt19937_64 generator(sequence);
  // Not a standard distribution: their numbers differ from library to library.
  const auto uniform = [&] { return double(generator() >> 11) * 0x1p-53; };
  const double scale = std::exp2(-4 * uniform());
  std::vector<double> x;
  for (const Interval& interval : box) {
    x.push_back(approx_double(interval.midpoint()) + scale * (uniform() - 0.5) * approx_double(interval.width()));
  }
  return x;
}

/// A rational near x, in the interval. \param tolerance a power of two
Rational rounded_into(const Interval& interval, double x, int bits) {
  const Rational centre = Rational(Integer(std::llround(std::ldexp(x, 40)))) / power(Rational(2), 40);
  const Rational tolerance = 1 / power(Rational(2), bits);
  const Rational lower = std::max(Rational(centre - tolerance), interval.lower);
  const Rational upper = std::min(Rational(centre + tolerance), interval.upper);
  return lower > upper ? interval.midpoint() : simplest_between(lower, upper);
}

}  // namespace

SearchTrial search_trial(const Scheme& scheme, int m, const SpectrumScreen& screen, const Box& box, unsigned seed, int start,
                         const ProofLimits& limits, const Stop& stop) {
  const Objective objective(screen, box, stop);
  SearchTrial trial;
  trial.start = start;
  std::vector<double> x = random_start(box, seed, start);
  if (!x.empty()) {
    ApproxMinimum best{x, objective(x, 0)};
    for (const int p : {2, 8, 32, 0, 0, 0}) {
      ApproxMinimum found =
          approx_minimum([&](std::span<const double> at) { return objective(at, p); }, x, p > 0 ? 0.2 : 0.05, iterations);
      x = std::move(found.x);
      if (const double value = objective(x, 0); value < best.value) best = {x, value};
    }
    x = best.x;
  }
  // Parameter by parameter as short as possible, without losing more than a part of the distance to 1.
  const double found = objective(x, 0);
  const double allowed = found < 1 ? found + (1 - found) / 4 : found * 1.001;
  for (std::size_t k = 0; k < x.size(); ++k) {
    for (int bits = 0; bits <= 40; ++bits) {
      const double before = x[k];
      const Rational rounded = rounded_into(box[k], before, bits);
      x[k] = approx_double(rounded);
      if (bits == 40 || objective(x, 0) <= allowed) {
        trial.parameters.push_back(rounded);
        break;
      }
      x[k] = before;
    }
  }
  trial.approx_radius = objective(x, 0);
  if (trial.approx_radius >= 1) return trial;
  Claim claim;
  claim.smoothness = m;
  for (const Rational& value : trial.parameters) claim.region.push_back(Interval::point(value));
  trial.verdict = prove(scheme, claim, limits, stop);
  if (trial.verdict->interrupted) throw Interrupted("interrupted");
  return trial;
}

}  // namespace limes
