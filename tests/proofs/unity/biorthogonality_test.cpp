#include "proofs/unity/biorthogonality.hpp"

#include "algebra/number/read_rational.hpp"
#include "proofs/checker/checker.hpp"
#include "schemes/catalogue.hpp"
#include "schemes/unity/multiresolution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace limes {
namespace {

Multiresolution found(const Mask& mask, int extension, Arithmetic arithmetic = Arithmetic::exact) {
  MultiresolutionOptions options;
  options.extension = extension;
  options.arithmetic = arithmetic;
  return find_multiresolution(mask.symbol.rational_coefficients(), options);
}

Mask mask_of(std::initializer_list<const char*> texts) {
  std::vector<Rational> coefficients;
  for (const char* text : texts) coefficients.push_back(read_rational(text));
  return {2, LaurentPolynomial::from_rationals(0, coefficients)};
}

TEST(Biorthogonality, CertificatesOfManyFiltersAreAccepted) {
  const std::filesystem::path directory = LIMES_BINARY_DIR "/certificates";
  std::filesystem::create_directories(directory);
  const Catalogue catalogue(LIMES_SOURCE_DIR "/schemes/catalogue");
  std::vector<std::pair<std::string, Mask>> masks;
  for (const char* name : {"chaikin", "b-spline-1", "b-spline-3", "b-spline-8", "deslauriers-dubuc-12"})
    masks.emplace_back(name, catalogue.load(name).mask);
  masks.emplace_back("interpolating-cinpact", mask_of({"0.0240126", "0", "-0.129882", "0", "0.606154", "0.99909",
                                                       "0.606154", "0", "-0.129882", "0", "0.0240126"}));
  masks.emplace_back("asymmetric", mask_of({"1/3", "-2", "5/7", "1", "0", "4", "1/9"}));
  for (const auto& [name, mask] : masks) {
    for (const int extension : {0, 2, 10}) {
      const FilterBank bank = found(mask, extension).bank;
      const BiorthogonalityProof proof = prove_biorthogonality(name, mask, bank);
      ASSERT_FALSE(proof.certificate_json.empty());
      EXPECT_TRUE(checker::check(proof.certificate_json).valid);
      // ||A|| >= 1 / sigma_min(P), because A P = I.
      EXPECT_GE(proof.norm_a.upper * proof.sigma_min_p.upper, 1);
      for (const RationalBounds& bounds : {proof.orthogonality_error, proof.sigma_min_p, proof.norm_a, proof.norm_b}) {
        EXPECT_LE(bounds.lower, bounds.upper);
        EXPECT_LE(bounds.upper - bounds.lower, power(Rational(10), -9) * (1 + bounds.upper));
      }
      std::ofstream(directory / (name + ".multiresolution." + std::to_string(extension) + ".json"))
          << proof.certificate_json;
    }
  }
}

TEST(Biorthogonality, RoundedFiltersHaveNoCertificate) {
  const Mask mask = mask_of({"1/8", "1/2", "3/4", "1/2", "1/8"});
  const FilterBank bank = found(mask, 2, Arithmetic::binary64).bank;
  EXPECT_GT(exact_biorthogonality_defect(bank), 0);
  EXPECT_TRUE(prove_biorthogonality("rounded", mask, bank).certificate_json.empty());
}

TEST(Biorthogonality, NormsOfTheDegree6PolynomialAreLarge) {
  // A small orthogonality error does not make stable filters: sigma_min(P) does not depend on the extension.
  const Mask mask = mask_of({"0.218601", "0.487201", "0.593167", "0.487201", "0.218601"});
  const BiorthogonalityProof proof = prove_biorthogonality("polynomial-6", mask, found(mask, 32).bank);
  EXPECT_LT(proof.orthogonality_error.upper, Rational(1) / 10);
  EXPECT_GT(proof.norm_a.lower, 6);
  EXPECT_NEAR(approx_double(proof.sigma_min_p.lower), 0.155965, 1e-6);
}

}  // namespace
}  // namespace limes
