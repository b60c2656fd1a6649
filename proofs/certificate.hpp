#pragma once

#include "analysis/uniform/stability.hpp"
#include "schemes/scheme.hpp"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace limes {

/// The theorems that verdicts rest on (docs/theory.md).
enum class Theorem {
  /// Contractivity of the difference scheme proves C^m. [Dyn 1992; Dyn & Levin 2002]
  u1,
  /// A missing factor or an expanding word of difference sections disproves C^m. [Dyn & Levin 2002]
  u2,
};

std::string to_string(Theorem theorem);

/// ||S_b^level|| < 1 on the leaf (U1).
struct ContractionWitness {
  int level = 1;
};
/// sigma^{m+1} does not divide the symbol at any point of the leaf (U2).
struct MissingFactorWitness {};
/// The product of the difference sections along the word has spectral radius >= 1 on the leaf (U2).
struct WordWitness {
  std::vector<int> word;
};

/// One box of a proof with the witness that settles it.
struct ProofLeaf {
  Box region;
  std::variant<ContractionWitness, MissingFactorWitness, WordWitness> witness;
};

/// A complete proof of a verdict, self-contained: docs/certificate.md defines its JSON form and what limes-check verifies.
struct Certificate {
  std::string scheme;
  VariableNames parameters;
  Mask mask;
  Claim claim;
  /// certified or refuted
  Outcome verdict = Outcome::certified;
  Theorem theorem = Theorem::u1;
  /// For U2.
  std::optional<Stability> stability;
  std::vector<ProofLeaf> leaves;
};

/// The JSON text, deterministic byte by byte.
std::string to_json(const Certificate& certificate);

}  // namespace limes
