#include "schemes/unity/optimise_weight.hpp"

#include "algebra/error.hpp"
#include "algebra/number/read_rational.hpp"
#include "schemes/unity/weight_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace limes {
namespace {

OptimalParameter optimal_sigma(const std::string& function, const std::string& radius, const std::vector<std::string>& constraints) {
  WeightProblem problem;
  problem.function = function + "(c=" + radius + ", sigma=1)";
  problem.constraints = constraints;
  problem.samples = 401;
  const auto error = [&](const Rational& sigma) {
    set_argument(problem, "sigma", sigma);
    return derive_mask(problem, {}).least_error;
  };
  return optimise_parameter(error, {2, 20}, read_rational("1/100"), 32, {});
}

/// "For each c, the value of sigma is chosen to minimize the normalized error."
TEST(MoltajiRunionsSamavati2016, OptimalParametersOfTables2And3) {
  for (const auto& [radius, sigma] : {std::pair{"3", "7.27"}, {"4", "8.67"}, {"4.5", "14.78"}})
    EXPECT_EQ(optimal_sigma("cinpact", radius, {}).parameter, read_rational(sigma)) << radius;
  EXPECT_EQ(optimal_sigma("interpolating-cinpact", "5", {"interpolation"}).parameter, read_rational("4.79"));
}

TEST(OptimiseParameter, FindsTheLeastOfSeveralMinima) {
  const auto f = [](const Rational& x) { return std::cos(3 * approx_double(x)) + 0.1 * approx_double(x); };
  const OptimalParameter found = optimise_parameter(f, {0, 6}, read_rational("1/1000"), 40, {});
  EXPECT_EQ(found.local_minima.size(), 3u);
  EXPECT_NEAR(approx_double(found.parameter), 1.036, 0.0011);
}

TEST(OptimiseParameter, EndsOfTheIntervalCount) {
  const auto f = [](const Rational& x) { return approx_double(x); };
  EXPECT_EQ(optimise_parameter(f, {read_rational("1/3"), 6}, read_rational("1/100"), 10, {}).parameter, read_rational("1/3"));
  EXPECT_THROW(optimise_parameter(f, {0, 6}, 0, 10, {}), InputError);
}

}  // namespace
}  // namespace limes
