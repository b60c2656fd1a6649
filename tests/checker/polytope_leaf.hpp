// U1 certificates with one leaf, proved by a polytope norm, fixed or moving.
#pragma once

#include "tests/checker/certificates.hpp"

namespace limes::test {

// a = (1+z)^2 b / 2 with b = (1/2 + w) + (1/2 - w) z: the sections are the numbers 1/2 + w and 1/2 - w.
inline Claim tilted(const std::string& w) { return {{"w"}, {"1/4+w/2", "3/4+w/2", "3/4-w/2", "1/4-w/2"}, "C1", {{"w", w}}}; }

inline Json by_polytope(const Claim& claim, const Json& polytope) {
  return certificate(claim, "certified", "U1", {{"leaves", {{{"region", claim.region}, {"polytope", polytope}}}}});
}

}  // namespace limes::test
