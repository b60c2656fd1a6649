// Rules and random knots for the tests of this folder.
#pragma once

#include "schemes/catalogue.hpp"
#include "schemes/nonuniform/insertion_rule.hpp"
#include "tests/algebra/generators.hpp"

#include <filesystem>

namespace limes::test {

inline Scheme catalogue_scheme(const std::string& name) {
  return Catalogue(std::filesystem::path(LIMES_SOURCE_DIR) / "schemes/catalogue").load(name);
}

inline InsertionRule catalogue_rule(const std::string& name) { return catalogue_scheme(name).insertion_rule.value(); }

inline InsertionRule make_rule(int points, const std::vector<std::pair<std::string, std::string>>& let,
                               const std::string& new_point, const VariableNames& parameters = {}) {
  InsertionRuleText text;
  text.points = points;
  for (const auto& [name, value] : let) text.let.push_back({name, {value, 0}});
  text.new_point = {new_point, 0};
  return InsertionRule(text, parameters);
}

/// Strictly increasing, with ratios up to about 100.
inline std::vector<Rational> random_knots(Generator& random, int count) {
  std::vector<Rational> knots{random.rational()};
  while (static_cast<int>(knots.size()) < count) knots.push_back(knots.back() + abs(random.non_zero_rational(10)));
  return knots;
}

inline std::vector<Rational> powers(const std::vector<Rational>& knots, int exponent) {
  std::vector<Rational> result;
  for (const Rational& t : knots) result.push_back(power(t, exponent));
  return result;
}

template <class K>
K combination(const std::vector<K>& weights, const std::vector<K>& points) {
  K sum = weights[0] * points[0];
  for (std::size_t k = 1; k < weights.size(); ++k) sum += weights[k] * points[k];
  return sum;
}

}  // namespace limes::test
