// What the three arithmetics of find_multiresolution have in common. Included by its sources only.
#pragma once

#include "schemes/unity/multiresolution.hpp"

namespace limes::multiresolution_impl {

/// The best q for one shift.
struct Candidate {
  int shift = 0;
  std::vector<Rational> q;
  Rational squared_error;
};

/// The best q for every shift 2i - K that has one, i = 1 .. K - 1 - l/2. \param p of even length K, l zeros at its end
std::vector<Candidate> exact_candidates(const std::vector<Rational>& p, int extension);
std::vector<Candidate> approx_candidates_binary64(const std::vector<Rational>& p, int extension);
std::vector<Candidate> approx_candidates_multiprecision(const std::vector<Rational>& p, int extension, int digits);

}  // namespace limes::multiresolution_impl
