#pragma once

#include "algebra/polynomial/box.hpp"
#include "schemes/nonstationary/exponential_function.hpp"
#include "schemes/surface/valence_range.hpp"

#include <optional>
#include <string>

namespace limes {

enum class Outcome { certified, refuted, undecided };

std::string to_string(Outcome outcome);

/// About a nonstationary scheme: every step maps the samples of these functions of y to samples of themselves (reproduces), or to
/// samples of functions of the space that they and their shifts span (generates). The negated statement says so of none of
/// them at any angle of the region; a cos stands there for the plane that it spans with its sin.
struct SpaceStatement {
  bool generates = false;
  std::vector<ExponentialFunction> functions;
};
/// What a claim is about: the scheme itself; its projective version, which refines weights that start as ones together with weighted points and divides
/// by them; the statement that the scheme has no continuous limits but zero; or the spectral condition at extraordinary vertices.
enum class ClaimSubject { limits, projective_limits, zero_limits, vertex_spectrum };

/// A statement about a scheme, as a scheme file makes it: "C^m for every parameter value in the region", or, negated, "not C^m
/// at any parameter value in the region". The source or the reader's hope may be wrong: then another outcome is expected and
/// the erratum says why.
struct Claim {
  int smoothness = 0;
  bool negated = false;
  /// Instead of smoothness.
  std::optional<SpaceStatement> space = std::nullopt;
  /// Of a nonstationary scheme.
  AngleType type = AngleType::trigonometric;
  ClaimSubject subject = ClaimSubject::limits;
  /// Of a surface scheme: the valences of the extraordinary vertices (faces) that it is about.
  std::optional<ValenceRange> valences = std::nullopt;
  /// One interval per parameter of the scheme, in the scheme's order.
  Box region;
  Outcome expected = Outcome::certified;
  std::string source;
  std::string erratum;
  /// Line of the scheme file, 0 for a claim from elsewhere.
  int line = 0;
};

/// "C^m" or "not C^m" of the scheme itself.
inline bool is_about_smoothness(const Claim& claim) { return !claim.space && claim.subject == ClaimSubject::limits; }

/// "C2" or "not C2"; "reproduces {1, y, cos, sin}", "does not generate {y^2}"; "projective C0", "not projective C1"; "only zero limits";
/// "spectral-condition".
std::string statement(const Claim& claim);

/// Reads what statement() writes, 0 <= m <= 64, into a claim without a region. \throws InputError
Claim read_statement(const std::string& text);

}  // namespace limes
