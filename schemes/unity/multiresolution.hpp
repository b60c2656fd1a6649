#pragma once

#include "algebra/stop.hpp"
#include "schemes/unity/filter_bank.hpp"

#include <optional>
#include <vector>

namespace limes {

enum class Arithmetic {
  /// Over Q: the optimum itself.
  exact,
  /// MPFR numbers, by orthogonal factorisations.
  multiprecision,
  /// The same in double precision.
  binary64,
};

struct MultiresolutionOptions {
  /// l: by how many zeros p is extended at most; even, at most max_extension.
  int extension = 0;
  /// Extend by 2 until the orthogonality error is at most this; `extension` is the cap then.
  std::optional<Rational> threshold;
  /// Use this shift instead of the best one.
  std::optional<int> shift;
  Arithmetic arithmetic = Arithmetic::exact;
  /// Decimal digits of Arithmetic::multiprecision, 20 to 1000.
  int digits = 50;
};

constexpr int max_extension = 128;
constexpr int max_mask_length = 128;

/// One extension tried: its best shift and ||P^T q||^2 there.
struct ExtensionStep {
  int extension = 0;
  int shift = 0;
  Rational squared_error;
};

struct Multiresolution {
  FilterBank bank;
  Rational squared_error;
  /// All extensions tried, in order.
  std::vector<ExtensionStep> steps;
  bool threshold_reached = true;
};

/// Algorithm 5.1 of Moltaji, Runions & Samavati 2017, corrected: among the q of length K = k + l with BQ = I for some shift
/// (hard constraints), one with the least orthogonality error ||P^T q||_2.
///
/// - The shift of row i of the hard constraints is 2i - K with the extended length K.
/// - An extension that does not improve the error is not taken: the filters of the shorter one are returned.
/// - Of shifts with the same error (mirror images, for a symmetric mask) the one of least modulus is taken, of two such the
///   negative one. Exact arithmetic compares exactly, the others up to half of their digits.
/// - Returned are p with its zeros, and in inexact arithmetic the exact values of the numbers that were computed.
///
/// Such q exist, for every extension, if and only if the even and the odd part of the mask have no common zero but 0. Then
/// all of them are q_0 + w(z^2) p(z), so that the error is to be minimised over the l/2 + 1 coefficients of w only.
///
/// \param mask first and last entry not zero
/// \throws InputError: the parts have a common zero, the mask is too long or has fewer than two entries, an option is out of
/// its range. Interrupted.
Multiresolution find_multiresolution(const std::vector<Rational>& mask, const MultiresolutionOptions& options,
                                     const Stop& stop = {});

}  // namespace limes
