#pragma once

#include "algebra/polynomial/box.hpp"

namespace limes {

/// Closed rational intervals that contain the values of elementary functions, by ball arithmetic (Arb), of relative
/// width about 2^-bits. \pre 16 <= bits <= 10000
Interval pi_enclosure(int bits = 128);
/// cos x. \pre |x| <= 1000
Interval cos_enclosure(const Rational& x, int bits = 128);
/// cosh x. \pre |x| <= 1000
Interval cosh_enclosure(const Rational& x, int bits = 128);

}  // namespace limes
