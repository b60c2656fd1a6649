#include "analysis/nonuniform/isolated_ratio.hpp"

namespace limes {

std::vector<std::vector<RationalFunction>> isolated_ratio_stencils(const InsertionRule& rule, const Box& region) {
  const int variables = rule.parameters() + 1;
  const RationalFunction gamma = RationalFunction::variable(variables, rule.parameters());
  std::vector<std::vector<RationalFunction>> stencils;
  for (int k = 0; k <= rule.points() - 2; ++k) {
    // Knot number rule.points() - k (from 1) is the extraordinary one; for k = 0 the whole stencil lies left of it.
    std::vector<RationalFunction> knots;
    for (int j = 1; j <= rule.points(); ++j) {
      const int place = j - (rule.points() - k);
      const RationalFunction distance = RationalFunction::constant(variables, place);
      knots.push_back(place > 0 ? distance * gamma : distance);
    }
    std::vector<RationalFunction> stencil = rule.stencil(knots);
    for (RationalFunction& weight : stencil) {
      for (std::size_t a = 0; a < region.size(); ++a) {
        if (region[a].is_point()) weight = weight.substitute(static_cast<int>(a), region[a].lower);
      }
    }
    stencils.push_back(std::move(stencil));
  }
  return stencils;
}

bool is_mirror_symmetric(const std::vector<std::vector<RationalFunction>>& stencils) {
  const int points = static_cast<int>(stencils[0].size());
  const int variables = stencils[0][0].variables();
  const RationalFunction inverse =
      RationalFunction::constant(variables, 1) / RationalFunction::variable(variables, variables - 1);
  for (int j = 0; j < points; ++j) {
    if (!(stencils[0][j] == stencils[0][points - 1 - j])) return false;
    for (int k = 1; k <= points - 2; ++k) {
      if (!(stencils[k][j].substitute(variables - 1, inverse) == stencils[points - 1 - k][points - 1 - j])) return false;
    }
  }
  return true;
}

}  // namespace limes
