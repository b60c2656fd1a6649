#include "analysis/nonuniform/spectrum_dominance.hpp"

#include "algebra/error.hpp"

namespace limes {

SpectrumDominance prove_spectrum_dominance(const SplitCharacteristicPolynomial& split, const Box& region,
                                           const RootDominanceOptions& options, const Stop& stop) {
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
  const bool symmetric = split.is_symmetric();
  for (const bool mirror : {false, true}) {
    if (mirror && symmetric) break;
    for (const auto* factors : {&split.ell, &split.r}) {
      for (CharacteristicFactor factor : *factors) {
        if (mirror) factor.polynomial = mirrored(factor.polynomial);
        RootDominance dominance = prove_root_dominance(factor.polynomial, rho, box, options, stop);
        const bool proved = dominance.proved;
        if (!proved) result.reason = dominance.reason;
        result.parts.push_back({std::move(factor), mirror, std::move(dominance)});
        if (!proved) return result;
      }
    }
  }
  result.proved = true;
  return result;
}

}  // namespace limes
