#include "schemes/uniform/mask.hpp"

namespace limes {

std::optional<int> interpolatory_index(const Mask& mask) {
  const LaurentPolynomial& a = mask.symbol;
  if (a.is_zero()) return std::nullopt;
  const RationalFunction one = RationalFunction::constant(a.variables(), 1);
  for (int residue = 0; residue < mask.arity; ++residue) {
    std::optional<int> index;
    bool only_one = true;
    for (int i = a.lowest() + residue; i <= a.highest() && only_one; i += mask.arity) {
      const RationalFunction c = a.coefficient(i);
      if (c.is_zero()) continue;
      only_one = !index && c == one;
      index = i;
    }
    if (only_one && index) return index;
  }
  return std::nullopt;
}

Mask at(const Mask& mask, std::span<const Rational> point) { return {mask.arity, mask.symbol.at(point)}; }

}  // namespace limes
