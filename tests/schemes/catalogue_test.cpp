#include "schemes/catalogue.hpp"

#include "algebra/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>

namespace limes {
namespace {

const std::filesystem::path directory = std::filesystem::path(LIMES_SOURCE_DIR) / "schemes/catalogue";

TEST(Catalogue, EveryFileIsReadableAndNamedAfterItsScheme) {
  const Catalogue catalogue(directory);
  for (const std::string& name : catalogue.names()) {
    SCOPED_TRACE(name);
    const Scheme scheme = catalogue.load(name);
    EXPECT_EQ(scheme.name, name);
    EXPECT_TRUE(scheme.surface || !scheme.claims.empty());
    EXPECT_FALSE(scheme.sources.empty());
  }
}

TEST(Catalogue, HoldsTheUniformSchemes) {
  const std::vector<std::string> names = Catalogue(directory).names();
  for (const char* name : {"b-spline-1", "b-spline-2", "b-spline-3", "b-spline-4", "b-spline-5", "b-spline-6", "b-spline-7", "b-spline-8",
                           "chaikin", "four-point", "six-point", "eight-point", "ten-point", "deslauriers-dubuc-6", "deslauriers-dubuc-8",
                           "deslauriers-dubuc-10", "deslauriers-dubuc-12", "twelve-point", "dual-four-point", "ternary-four-point",
                           "six-point-weissman-a", "six-point-weissman-b"}) {
    EXPECT_THAT(names, testing::Contains(name));
  }
}

TEST(Catalogue, NumbersAreOrderedByValue) {
  const std::vector<std::string> names = Catalogue(directory).names();
  const auto place = [&](const char* name) { return std::find(names.begin(), names.end(), name); };
  EXPECT_LT(place("deslauriers-dubuc-8"), place("deslauriers-dubuc-10"));
}

TEST(Catalogue, EverySourceIsInTheBibliography) {
  std::ifstream stream(std::filesystem::path(LIMES_SOURCE_DIR) / "references.bib");
  const std::string bibliography(std::istreambuf_iterator<char>(stream), {});
  const Catalogue catalogue(directory);
  for (const std::string& name : catalogue.names()) {
    const Scheme scheme = catalogue.load(name);
    std::vector<std::string> keys = scheme.sources;
    for (const Claim& claim : scheme.claims) {
      if (!claim.source.empty()) keys.push_back(claim.source);
    }
    for (const std::string& key : keys) {
      EXPECT_NE(bibliography.find("{" + key + ","), std::string::npos) << name << " cites " << key;
    }
  }
}

TEST(Catalogue, AnUnknownNameGetsTheNearestKnownOne) {
  try {
    Catalogue(directory).load("four-pint");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'four-point'?"), std::string::npos) << error.what();
  }
}

// Dyn, Floater & Hormann 2004; Hassan, Ivrissimtzis, Dodgson & Sabin 2002; Karciauskas & Peters 2013, Table 1 as corrected.
TEST(Catalogue, EverySymbolHasTheSumOfItsArityUnlessTheFileSaysSo) {
  const Catalogue catalogue(directory);
  for (const std::string& name : catalogue.names()) {
    const Scheme scheme = catalogue.load(name);
    if (scheme.surface) continue;  // has no mask
    const int variables = scheme.mask.symbol.variables();
    const bool only_zero_limits = std::any_of(scheme.claims.begin(), scheme.claims.end(),
                                              [](const Claim& claim) { return claim.subject == ClaimSubject::zero_limits; });
    if (!only_zero_limits) { EXPECT_EQ(scheme.mask.symbol(1), RationalFunction::constant(variables, scheme.mask.arity)) << name; }
  }
}

}  // namespace
}  // namespace limes
