#pragma once

#include "proofs/checker/checker.hpp"
#include "proofs/prove.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace limes::test {

/// What prove() says; a certificate is left where all of them are checked once more.
inline Verdict decide(const Scheme& scheme, const std::string& text, const std::string& w = "", const ProofLimits& limits = {}) {
  static int count = 0;
  Claim claim = read_statement(text);
  claim.region = scheme.parameter_box();
  if (!w.empty()) claim.region = {read_interval(w)};
  const Verdict verdict = prove(scheme, claim, limits);
  if (verdict.certificate) {
    EXPECT_TRUE(checker::check(verdict.certificate_json).valid);
    const std::filesystem::path directory = std::filesystem::path(LIMES_BINARY_DIR) / "certificates/nonuniform";
    std::filesystem::create_directories(directory);
    const std::string suite = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::ofstream(directory / (scheme.name + "." + suite + "." + std::to_string(++count) + ".json")) << verdict.certificate_json;
  }
  return verdict;
}

/// A rule of the reader's own: the table [nonuniform] and what belongs to it, with a parameter w in [0, 1/4].
inline Scheme own_scheme(const std::string& nonuniform) {
  return read_scheme("name = \"own\"\nkind = \"nonuniform\"\n[parameters]\nw = [\"0\", \"1/4\"]\n" + nonuniform, "own.toml");
}
inline Scheme own(const std::string& rule, int points, const std::string& let = "") {
  return own_scheme("[nonuniform]\npoints = " + std::to_string(points) + "\n[nonuniform.let]\n" + let +
                    "\n[nonuniform.rule]\nnew = \"\"\"" + rule + "\"\"\"\n");
}
inline Scheme own_coefficients(const std::string& list, int points, const std::string& let = "") {
  return own_scheme("[nonuniform]\npoints = " + std::to_string(points) + "\n[nonuniform.let]\n" + let +
                    "\n[nonuniform.rule]\ncoefficients = [" + list + "]\n");
}

}  // namespace limes::test
