#pragma once

#include "algebra/polynomial/box.hpp"

#include <string>

namespace limes {

enum class Outcome { certified, refuted, undecided };

std::string to_string(Outcome outcome);

/// What a claim is about: the scheme itself; its projective version, which refines weights that start as ones together with weighted points and divides
/// by them; or the statement that the scheme has no continuous limits but zero.
enum class ClaimSubject { limits, projective_limits, zero_limits };

/// A statement about a scheme, as a scheme file makes it: "C^m for every parameter value in the region", or, negated, "not C^m
/// at any parameter value in the region". The source or the reader's hope may be wrong: then another outcome is expected and
/// the erratum says why.
struct Claim {
  int smoothness = 0;
  bool negated = false;
  ClaimSubject subject = ClaimSubject::limits;
  /// One interval per parameter of the scheme, in the scheme's order.
  Box region;
  Outcome expected = Outcome::certified;
  std::string source;
  std::string erratum;
  /// Line of the scheme file, 0 for a claim from elsewhere.
  int line = 0;
};

/// "C2" or "not C2"; "projective C0", "not projective C1"; "only zero limits".
std::string statement(const Claim& claim);

/// Reads what statement() writes, 0 <= m <= 64, into a claim without a region. \throws InputError
Claim read_statement(const std::string& text);

}  // namespace limes
