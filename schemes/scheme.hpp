#pragma once

#include "schemes/claim.hpp"
#include "schemes/nonstationary/mask_sequence.hpp"
#include "schemes/nonuniform/insertion_rule.hpp"
#include "schemes/surface/surface_rule.hpp"
#include "schemes/uniform/mask.hpp"
#include "schemes/unity/weight_problem.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limes {

struct Parameter {
  std::string name;
  /// Where the definition makes sense; claims lie inside.
  Interval range;
};

enum class SchemeKind { uniform, nonuniform, nonstationary, surface };

std::string to_string(SchemeKind kind);

/// A scheme as its file defines it, with the claims made about it.
struct Scheme {
  std::string name;
  std::string title;
  SchemeKind kind = SchemeKind::uniform;
  /// Keys of references.bib.
  std::vector<std::string> sources;
  std::vector<Parameter> parameters;
  /// Of a non-uniform scheme: its mask for equal knot intervals, E(1, .., 1). Of a nonstationary one: the limit of its masks, which
  /// says nothing about the scheme by itself.
  Mask mask;
  /// The rule that the mask was made from; empty when the file gives the mask, or coefficients.
  std::string rule;
  /// What the mask was derived from by least squares, if the file says so.
  std::optional<WeightProblem> weight;
  /// Of a non-uniform scheme only.
  std::optional<InsertionRule> insertion_rule;
  /// Of a nonstationary scheme only; its angle is the only parameter, in the hull of the ranges of its types.
  std::optional<MaskSequence> sequence;
  /// Of a surface scheme only, which has no mask; its parameters are those of its curve scheme.
  std::optional<SurfaceRule> surface;
  std::vector<Claim> claims;
  std::filesystem::path file;

  /// Whose angle is the only parameter: of a nonstationary scheme, or of a surface scheme's curve scheme; nullptr for others.
  const MaskSequence* level_sequence() const {
    return sequence ? &*sequence : surface && !parameters.empty() ? &surface->sequence : nullptr;
  }
  VariableNames parameter_names() const;
  Box parameter_box() const;
};

/// Reads a scheme file (TOML, docs/scheme-files.md).
/// \throws InputError "file:line: reason" for malformed TOML, unknown keys, wrong types, expressions that do not parse, poles
/// for every parameter value, claims outside of the parameter box, ...
Scheme read_scheme_file(const std::filesystem::path& file);
/// The same from a text; `file` only names it in messages.
Scheme read_scheme(std::string_view text, const std::filesystem::path& file);

}  // namespace limes
