// SPDX-License-Identifier: MIT
//
// Bounds of the joint spectral radius lim max ||B_{w_1} .. B_{w_k}||^{1/k} of rational matrices. Below: the spectral radius of one
// product. Above: norms of blocks on the diagonal of a common block triangular form, of whose radii it is the greatest.
#include "proofs/checker/certificate.hpp"
#include "proofs/checker/json.hpp"
#include "proofs/checker/modular.hpp"
#include "proofs/checker/polytope.hpp"
#include "proofs/checker/theorems.hpp"

namespace limes::checker {
namespace {

/// det(lambda - N) for an integer matrix: coefficients from the constant one on, by residues for proven bounds.
std::vector<mpz_class> characteristic_polynomial(const std::vector<mpz_class>& entries, std::size_t n, Budget& budget) {
  mpz_class bound = 1;
  for (std::size_t i = 0; i < n; ++i) {
    mpz_class sum = 1;
    for (std::size_t j = 0; j < n; ++j) sum += abs(entries[i * n + j]);
    budget.work(500 + 8 * limbs(bound) * limbs(sum));
    bound *= sum;
  }
  const double bits = static_cast<double>(mpz_sizeinbase(bound.get_mpz_t(), 2)) + 2, size = static_cast<double>(n);
  budget.work(moduli_for(bits) * (charpoly_cost(size) + 500 * size + size * size * (30 + bits / 10) + 1e5));
  Reconstruction reconstruction(n + 1, bound + 1);
  for (mpz_class p = next_modulus(); !reconstruction.is_complete(); p = next_modulus(p)) {
    const Modulus f(p);
    std::vector<Residue> matrix;
    for (const mpz_class& entry : entries) matrix.push_back(f.from(entry));
    const std::vector<Residue> chi = checker::characteristic_polynomial(f, std::move(matrix), n);
    if (!chi.empty()) reconstruction.add(f, chi);
  }
  return reconstruction.result();
}

}  // namespace

void prove_radius_at_least(const std::vector<RationalMatrix>& family, const Json& word, const mpq_class& bound, Budget& budget) {
  const std::string step = "lower";
  if (bound == 0) return;
  if (!word.is_array() || word.empty() || word.size() > 64) throw Rejected{step, "a lower bound needs a word of 1 to 64 letters"};
  const std::size_t n = family[0].rows;
  RationalMatrix result(n, n);
  for (std::size_t i = 0; i < n; ++i) result.at(i, i) = 1;
  mpq_class power = 1;
  for (const Json& letter : word) {
    if (!letter.is_number_unsigned() || letter.get<std::uint64_t>() >= family.size()) throw Rejected{step, "the word has an unknown letter"};
    result = product(result, family[letter.get<std::size_t>()], budget);
    budget.work(200 + 20 * limbs(power) * limbs(bound));
    power *= bound;
  }
  mpz_class denominator = 1;
  for (const mpq_class& x : result.entries) {
    budget.work(500 + 20 * limbs(denominator) * limbs(x));
    denominator = lcm(denominator, x.get_den());
  }
  std::vector<mpz_class> entries;
  for (const mpq_class& x : result.entries) {
    budget.work(500 + 20 * limbs(denominator) * limbs(x));
    entries.push_back(x.get_num() * (denominator / x.get_den()));
  }
  // With radius t = denominator * bound^k = p / q: lambda = t z, the coefficients c_i p^i q^{n-i}.
  std::vector<mpz_class> chi = characteristic_polynomial(entries, n, budget);
  const mpq_class radius = power * denominator;
  mpz_class scale = 1;
  for (std::size_t i = 0; i <= n; ++i) {
    budget.work(200 + 8 * limbs(chi[i]) * limbs(scale));
    chi[i] *= scale;
    budget.work(200 + 8 * limbs(radius) * limbs(scale));
    scale *= radius.get_num();
  }
  scale = 1;
  for (std::size_t i = n + 1; i-- > 0;) {
    budget.work(400 + 8 * (limbs(chi[i]) + limbs(radius)) * limbs(scale));
    chi[i] *= scale;
    scale *= radius.get_den();
  }
  if (all_roots_inside(std::move(chi), budget)) throw Rejected{step, "the word's product has a smaller spectral radius"};
}

namespace {

/// Six decimals, rounded down or up. \pre x >= 0
std::string decimal(const mpq_class& x, bool up) {
  const mpz_class scaled = x.get_num() * 1000000;
  mpz_class quotient;
  (up ? mpz_cdiv_q : mpz_fdiv_q)(quotient.get_mpz_t(), scaled.get_mpz_t(), x.get_den_mpz_t());
  std::string text = quotient.get_str();
  if (text.size() < 7) text.insert(0, 7 - text.size(), '0');
  return text.insert(text.size() - 6, ".");
}

}  // namespace

void prove_radius(const std::vector<RationalMatrix>& family, const RadiusBounds& claim, const Json& json, Budget& budget) {
  const Reader proof(json, "proof", "the proof", {"word", "form", "blocks"});
  if (claim.lower < 0 || claim.lower > claim.upper) proof.fail("has a claim with lower < 0 or lower > upper");
  const Blocks blocks = diagonal_blocks(family, proof.at("form"), budget);
  const Json& polytopes = proof.list("blocks", blocks.families.size(), blocks.families.size());
  std::vector<RadiusBounds> bounds;
  for (std::size_t k = 0; k < blocks.families.size(); ++k) {
    const bool exact = polytopes[k].is_object() && polytopes[k].contains("polynomial");
    if (exact) {
      bounds.push_back(prove_exact_polytope(blocks.families[k], polytopes[k], budget));
    } else {
      const Reader reader(polytopes[k], "polytope", "a block", {"bound", "polytope"});
      bounds.push_back({0, read_number(reader.at("bound"), "polytope", "a bound", budget), {}});
      prove_polytope(blocks.families[k], bounds.back().upper, reader.at("polytope"), budget);
    }
    if (bounds.back().upper > claim.upper) throw Rejected{"upper", "a block has a greater bound"};
  }
  prove_radius_at_least(family, proof.at("word"), claim.lower, budget);
  if (claim.polynomial.empty()) return;
  // One block's radius is a root of the polynomial and at least as great as all others.
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    if (bounds[k].polynomial != claim.polynomial || bounds[k].lower < claim.lower) continue;
    bool greatest = true;
    for (std::size_t j = 0; j < bounds.size(); ++j) greatest = greatest && (j == k || bounds[j].upper <= bounds[k].lower);
    if (greatest) return;
  }
  throw Rejected{"upper", "no block has the claimed radius, at least as great as those of the others"};
}

std::string check_joint_spectral_radius(const Json& json, Budget& budget) {
  const Reader reader(json, "format", "the certificate", {"format", "version", "theorem", "matrices", "claim", "proof"});
  std::vector<RationalMatrix> family;
  for (const Json& matrix : reader.list("matrices", 1, 64)) {
    family.push_back(read_matrix(matrix, "format", "a matrix", budget));
    const RationalMatrix& b = family.back();
    if (b.rows != b.columns || b.rows != family[0].rows) reader.fail("has matrices that are not square of one size");
  }
  const Json& claim = reader.at("claim");
  const bool exact = claim.is_object() && claim.contains("polynomial");
  const Reader bounds(claim, "claim", "the claim", exact ? std::vector<std::string>{"lower", "upper", "polynomial"}
                                                         : std::vector<std::string>{"lower", "upper"});
  RadiusBounds radius{read_number(bounds.at("lower"), "claim", "lower", budget), read_number(bounds.at("upper"), "claim", "upper", budget), {}};
  if (exact)
    for (const Json& c : bounds.list("polynomial", 2, 65)) radius.polynomial.push_back(read_number(c, "claim", "the polynomial", budget));
  prove_radius(family, radius, reader.at("proof"), budget);
  return "certified: the joint spectral radius of " + std::to_string(family.size()) + " matrices lies between " + decimal(radius.lower, false) +
         " and " + decimal(radius.upper, true) + (exact ? " and is a root of the polynomial" : "") + " (theorem JSR)";
}

}  // namespace limes::checker
