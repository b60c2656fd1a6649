#include "proofs/verdict.hpp"

namespace limes {

int Verdict::level() const {
  int level = 0;
  if (!certificate) return level;
  for (const ProofLeaf& leaf : certificate->leaves) {
    if (const auto* contraction = std::get_if<ContractionWitness>(&leaf.witness)) level = std::max(level, contraction->level);
  }
  return level;
}

}  // namespace limes
