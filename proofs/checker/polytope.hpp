// SPDX-License-Identifier: MIT
#pragma once

#include "proofs/checker/interval.hpp"

#include <nlohmann/json_fwd.hpp>

namespace limes::checker {

/// A dense matrix over Q, square where nothing else is said.
struct RationalMatrix {
  std::size_t rows = 0, columns = 0;
  std::vector<mpq_class> entries;  ///< row by row
  RationalMatrix() = default;
  RationalMatrix(std::size_t n, std::size_t m) : rows(n), columns(m), entries(n * m) {}
  mpq_class& at(std::size_t i, std::size_t j) { return entries[i * columns + j]; }
  const mpq_class& at(std::size_t i, std::size_t j) const { return entries[i * columns + j]; }
};

/// x += y z, after the budget was charged for it.
void add_product(mpq_class& x, const mpq_class& y, const mpq_class& z, Budget& budget);
RationalMatrix product(const RationalMatrix& a, const RationalMatrix& b, Budget& budget);
/// A list of lists of rationals, all of one length. \throws Rejected at `step`
RationalMatrix read_matrix(const nlohmann::json& json, const std::string& step, const std::string& what, Budget& budget);

/// A rational, after the budget was charged for it. \throws Rejected at `step`
mpq_class read_number(const nlohmann::json& value, const std::string& step, const std::string& what, Budget& budget);
/// An element of C^n; the imaginary parts are empty for real vectors.
struct Vector {
  std::vector<mpq_class> real, imaginary;
};
Vector product(const RationalMatrix& b, const Vector& x, Budget& budget);

/// An upper bound of sqrt(x^2 + y^2), less than 2^-63 above it.
mpq_class modulus(const mpq_class& x, const mpq_class& y, Budget& budget);
/// x -= (re + i im) y, or (re + i im) conj(y). \pre x has imaginary parts when the product has
void subtract(Vector& x, const mpq_class& re, const mpq_class& im, const Vector& y, bool conjugated, Budget& budget);

/// Diagonal blocks of T^{-1} B_e T, which is verified to be block upper triangular.
struct Blocks {
  std::vector<std::vector<RationalMatrix>> families;
};
/// \param json null for one block, or {"basis": T, "inverse": T^{-1}, "sizes": [...]}. \throws Rejected at "blocks"
Blocks diagonal_blocks(const std::vector<RationalMatrix>& family, const nlohmann::json& json, Budget& budget);

/// The hull of all z v_j, z conj(v_j), z unit e_k, |z| = 1. Vectors that are known up to `errors` in each coordinate only are written
/// by their centres; no errors means exact.
struct Hull {
  std::vector<Vector> vectors;
  mpq_class unit;
  std::vector<mpq_class> errors;
};
/// Proves sum |c_j| + ||r||_1 / unit <= bound for y = sum of terms + r and every y within `error` of the one given.
/// \throws Rejected at "polytope"
void prove_inside(Vector y, const mpq_class& error, const nlohmann::json& terms, const Hull& hull, const mpq_class& bound,
                  const std::string& where, Budget& budget);

/// Proves ||B_e x|| <= bound ||x|| for a norm whose unit ball is a polytope, for every matrix of a family of one block; with
/// the norm of docs/certificate.md, "Polytope norms". \throws Rejected at "polytope"
void prove_polytope(const std::vector<RationalMatrix>& family, const mpq_class& bound, const nlohmann::json& polytope,
                    Budget& budget);

/// The bounds that a proof for one block gives: lower is 0 unless the polytope is exact.
struct RadiusBounds {
  mpq_class lower, upper;
  std::vector<mpq_class> polynomial;  ///< of which the radius is a root between the bounds; empty for a polytope with rational bound
};
/// Proves that the joint spectral radius of a family of one block is a root of a polynomial in an interval, with the exact
/// polytope of docs/certificate.md. \throws Rejected at "exact_polytope"
RadiusBounds prove_exact_polytope(const std::vector<RationalMatrix>& family, const nlohmann::json& polytope, Budget& budget);

/// Bounds of a joint spectral radius, with the proof {"word", "form", "blocks"}: see docs/certificate.md. With a polynomial: the radius is one of its
/// roots between the bounds. \throws Rejected at "lower", "blocks", "polytope", "exact_polytope" or "upper"
void prove_radius(const std::vector<RationalMatrix>& family, const RadiusBounds& claim, const nlohmann::json& proof, Budget& budget);

/// rho(B_word)^{1/k} >= bound for a word of length k, a list of letters. \throws Rejected at "lower"
void prove_radius_at_least(const std::vector<RationalMatrix>& family, const nlohmann::json& word, const mpq_class& bound, Budget& budget);

/// The joint spectral radius of the family is at most `bound`: {"form": null or as above, "blocks": [a polytope each]}. For
/// matrices affine in parameters on a box, the family of the matrices at all corners proves it on the whole box.
void prove_polytope_norm(const std::vector<RationalMatrix>& family, const mpq_class& bound, const nlohmann::json& norm,
                         Budget& budget);

/// For the matrices (1 - s) B_e(0) + s B_e(1): JSR(s) <= bound for all s in [0, 1], by polytopes whose vectors move with s; see
/// docs/certificate.md, "Moving polytopes". \param ends all B_e(0), then all B_e(1)
void prove_moving_norm(const std::vector<RationalMatrix>& ends, const mpq_class& bound, const nlohmann::json& norm, Budget& budget);

}  // namespace limes::checker
