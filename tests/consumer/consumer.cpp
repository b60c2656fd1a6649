// A user of the library: the symbol (1+x)^4 / 8 of the cubic B-spline, exactly.
#include <limes/algebra/number/read_rational.hpp>
#include <limes/algebra/polynomial/polynomial.hpp>

#include <iostream>

#ifdef CONSUMER_PROVES
bool chaikin_is_certified();  // proof.cpp
#else
static bool chaikin_is_certified() { return true; }
#endif

int main() {
  const limes::Rational eighth = limes::read_rational("0.125");
  const limes::Polynomial one_plus_x(std::vector<limes::Rational>{1, 1});
  const limes::Polynomial symbol = eighth * limes::power(one_plus_x, 4);
  std::cout << limes::to_string(symbol, "x") << '\n';
  const bool right = symbol(1) == 2 && symbol.coefficient(2) == limes::read_rational("3/4") &&
                     limes::divide(symbol, one_plus_x).second.is_zero();
  return right && chaikin_is_certified() ? 0 : 1;
}
