#include "schemes/uniform/interpolant_rule.hpp"

#include "schemes/nonuniform/insertion_rule.hpp"

namespace limes {

Mask mask_from_rule(const Expression& rule, const VariableNames& parameters) {
  return uniform_mask(InsertionRule(rule, parameters));
}

}  // namespace limes
