#include "analysis/nonuniform/spectrum_dominance.hpp"

#include "algebra/error.hpp"

namespace limes {

SpectrumDominance prove_spectrum_dominance(const SplitCharacteristicPolynomial& split, const Box& region,
                                           bool both_sides, const RootDominanceOptions& options,
                                           const Stop& stop) {
  if (region.size() + 1 != static_cast<std::size_t>(split.chi.variables())) {
    throw DomainError("a region has one interval for every parameter of the scheme");
  }
  SpectrumDominance result;
  if (split.missing_eigenvalue) {
    result.reason = "2^-" + std::to_string(*split.missing_eigenvalue) + " is no eigenvalue";
    return result;
  }
  Box box = region;
  box.push_back({0, 1, true, false});
  const Rational rho = power(Rational(2), -split.smoothness);
  for (const bool mirror : {false, true}) {
    if (mirror && !both_sides) break;
    for (const auto* factors : {&split.ell, &split.r}) {
      for (const CharacteristicFactor& factor : *factors) {
        const LambdaPolynomial tested = mirror ? mirrored(factor.polynomial) : factor.polynomial;
        result.parts.push_back({factor, mirror, prove_root_dominance(tested, rho, box, options, stop)});
        const RootDominance& dominance = result.parts.back().dominance;
        if (dominance.proved) continue;
        result.reason = "the roots of a factor of degree " + std::to_string(factor.polynomial.degree()) +
                        " are not dominated by " + to_string(rho) + (mirror ? ", with 1/gamma for gamma: " : ": ") +
                        dominance.reason;
        result.counterexample = dominance.counterexample;
        if (mirror && result.counterexample) result.counterexample->back() = 1 / result.counterexample->back();
        return result;
      }
    }
  }
  result.proved = true;
  return result;
}

}  // namespace limes
