// SPDX-License-Identifier: MIT
#pragma once

#include "proofs/checker/json.hpp"

namespace limes::checker {

/// The matrices (A_e)_{ij} = a_{e + 2j - i}, i, j = 0 .. size - 1, of a binary mask a_0 .. a_size of rationals, a_0 and a_size not 0:
/// they map `size` consecutive values of a sequence (in falling order of the index) to as many of the refined one.
struct Sections {
  std::string name;
  std::size_t size = 0;
  std::vector<mpz_class> mask;  ///< times `denominator`
  mpz_class denominator;
};

using IntegerMatrix = std::vector<mpz_class>;  ///< row by row

/// The keys of a certificate about one mask without parameters, read up to the claim.
struct MaskClaim {
  Sections scheme;
  std::string statement;
  bool certified = false;
};

/// \throws Rejected at "format", "scheme", "claim"
MaskClaim read_mask_claim(const Json& json, Budget& budget);
/// m of "<prefix>C<m>", 0 <= m <= 64; -1 when the statement has another form.
int smoothness_in(const std::string& statement, const std::string& prefix);
/// Letters 0 and 1.
std::vector<int> read_word(const Reader& reader, const char* key, std::size_t least, std::size_t most);

/// denominator A_e
IntegerMatrix section(const Sections& scheme, int letter);
/// A_{e_k} .. A_{e_1} times denominator^k, in the order in which a word e_1 .. e_k is applied.
IntegerMatrix apply_word(const Sections& scheme, const std::vector<int>& word, Budget& budget);

/// The cone of all t z with t >= 0 and lower <= z <= upper, 0 < lower < upper, times a common factor.
struct Cone {
  std::vector<mpz_class> lower, upper;
};

/// What follows for the points x_i / y_i when the weights y lie in the cone at every `level`-th step.
struct Contraction {
  /// Every `level` steps the oscillation within a window is multiplied by at most this, below 1.
  mpq_class factor;
  /// max_i sum_j |M_ij| for the matrices of rows with sum 1 that map the points.
  mpq_class norm;
};

/// Theorem P1 for the cone and level of the certificate's proof. \throws Rejected at "proof", "cone", "weights", "contraction", "limits"
Contraction prove_contraction(const Sections& scheme, const Cone& cone, int level, Budget& budget);
Cone read_cone(const Reader& proof, std::size_t size, Budget& budget);

/// "certified: NAME is STATEMENT (theorem ...)"
std::string mask_statement(const MaskClaim& claim, const std::string& proved, const std::string& theorem);

}  // namespace limes::checker
