// A user of the provers: a scheme of one's own, given as text, is proved to be C^1 and refuted to be C^2.
#include <limes/proofs/prove.hpp>

#include <iostream>

bool chaikin_is_certified() {
  const limes::Scheme scheme = limes::read_scheme(R"(
name = "corner-cutting"
kind = "uniform"
[uniform]
mask = ["1/4", "3/4", "3/4", "1/4"]
[[claims]]
claim = "C1"
[[claims]]
claim = "C2"
expect = "refuted"
erratum = "a quadratic B-spline is only C1"
)", "corner-cutting.toml");
  bool as_expected = scheme.claims.size() == 2;
  for (const limes::Claim& claim : scheme.claims) {
    const limes::Verdict verdict = limes::prove(scheme, claim);
    std::cout << limes::statement(claim) << ": " << limes::to_string(verdict.outcome) << ": " << verdict.reason << '\n';
    as_expected = as_expected && verdict.outcome == claim.expected;
  }
  return as_expected;
}
