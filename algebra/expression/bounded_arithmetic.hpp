#pragma once

#include "algebra/polynomial/rational_function.hpp"

namespace limes {

/// Arithmetic of rational functions for untrusted input: the size of every result is bounded from above before it is computed,
/// and the operations of one object together may cost about two seconds. So ((1+w)^1000)^1000, or a thousand coefficients of
/// degree 1000, are refused instead of computed. `column` is where errors point to.
class BoundedArithmetic {
 public:
  /// a op b, where op is one of + - * /. \throws InputError for a division by zero; LimitError when degrees above 1000, more
  /// than 100000 terms or more than 10000 digits would arise, or the work is spent.
  RationalFunction apply(char op, const RationalFunction& a, const RationalFunction& b, int column);
  /// a^exponent, with the same errors.
  RationalFunction power(const RationalFunction& a, int exponent, int column);

 private:
  double work_ = 0;
};

}  // namespace limes
