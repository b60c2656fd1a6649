#include "analysis/nonuniform/dominance_comparison.hpp"

#include "algebra/error.hpp"

namespace limes {

namespace {

MethodResult result_of(DominanceMethod method, const LambdaPolynomial& r, const Rational& rho, const Box& box, int max_boxes,
                       const Stop& stop) {
  RootDominanceOptions options;
  options.methods = {method};
  options.max_boxes = max_boxes;
  RootDominance dominance = prove_root_dominance(r, rho, box, options, stop);
  return {method, dominance.proved, static_cast<int>(dominance.leaves.size()), std::move(dominance.hopeless_point),
          std::move(dominance.counterexample)};
}

}  // namespace

std::vector<FactorComparison> compare_dominance_methods(const SplitCharacteristicPolynomial& split, const Box& region,
                                                        int max_boxes, const Stop& stop) {
  if (region.size() + 1 != static_cast<std::size_t>(split.chi.variables())) {
    throw DomainError("a region has one interval for every parameter of the scheme");
  }
  Box box = region;
  box.push_back({0, 1, true, false});
  const Rational rho = power(Rational(2), -split.smoothness);
  const bool symmetric = split.is_symmetric();
  std::vector<FactorComparison> result;
  for (const bool mirror : {false, true}) {
    if (mirror && symmetric) break;
    for (const auto* factors : {&split.ell, &split.r}) {
      for (const CharacteristicFactor& factor : *factors) {
        FactorComparison& comparison = result.emplace_back(FactorComparison{factor, factors == &split.ell, mirror, {}});
        const LambdaPolynomial tested = mirror ? mirrored(factor.polynomial) : factor.polynomial;
        for (const DominanceMethod method : {DominanceMethod::rouche, DominanceMethod::circle, DominanceMethod::boundary,
                                             DominanceMethod::sign_separation}) {
          comparison.methods.push_back(result_of(method, tested, rho, box, max_boxes, stop));
        }
      }
    }
  }
  return result;
}

}  // namespace limes
