// Rationals and regions in JSON: strings "p/q" and intervals "[p, q)". Included by sources only.
#pragma once

#include "algebra/polynomial/box.hpp"
#include "algebra/polynomial/multivariate_polynomial.hpp"

#include <nlohmann/json.hpp>

namespace limes {

inline nlohmann::ordered_json numbers_to_json(const std::vector<Rational>& numbers) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Rational& x : numbers) json.push_back(to_string(x));
  return json;
}

inline nlohmann::ordered_json region_to_json(const Box& region, const VariableNames& names) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (std::size_t k = 0; k < names.size(); ++k) json[names[k]] = to_string(region[k]);
  return json;
}

}  // namespace limes
