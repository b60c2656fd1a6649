// SPDX-License-Identifier: MIT
#pragma once

#include "proofs/checker/bernstein.hpp"
#include "proofs/checker/rule.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>

namespace limes::checker {

/// (S f)_i = sum_j a_{i - arity j} f_j with a_{first_index + k} = mask[k] / denominator; the first index proves
/// nothing.
struct Scheme {
  std::string name;
  std::vector<std::string> parameters;
  int arity = 0;
  std::vector<Polynomial> mask;
  Polynomial denominator;
};

/// One piece of a proof: a part of the region and the witness for it (a level or a polytope for U1; a word, or none,
/// for U2; a ratio of knot intervals for N3).
struct Leaf {
  Region region;
  int level = 0;
  bool missing_factor = false;
  std::vector<int> word;
  mpq_class gamma = 0;
  const nlohmann::json* polytope = nullptr;  ///< in the certificate, which outlives this
};

/// f = sum_s coefficients[s] lambda^s, variables: the parameters, then gamma.
struct Factor {
  std::vector<Polynomial> coefficients;
  int multiplicity = 1;
};

/// A part of the region times (0, 1] and the test that shows the roots of a factor to be small there.
struct Dominance {
  enum class Test { rouche, boundary, circle, separation };
  std::size_t factor = 0;
  Region region;  ///< of the parameters, then gamma
  Test test = Test::rouche;
  std::vector<mpq_class> cuts;     ///< of a circle test
  std::vector<Polynomial> curves;  ///< of a separation test
  std::vector<mpq_class> distances;
  bool mirrored = false;  ///< gamma stands for 1/gamma
};

enum class Theorem { U1, U2, N1, N3 };

/// A certificate of the right form, of which nothing is proved yet.
struct Certificate {
  Scheme scheme;  ///< of a non-uniform scheme: for equal intervals
  std::optional<Rule> rule;
  bool negated = false;  ///< "not C<order>"
  int order = 0;
  Region region;
  bool certified = false;  ///< or refuted
  Theorem theorem = Theorem::U1;
  bool interpolatory = false;  ///< or linear independence; of U2
  std::vector<Leaf> leaves;    ///< of N1: of its uniform part
  std::vector<Factor> factors;
  std::vector<Dominance> dominance;
  bool both_sides = false;  ///< of N1: gamma > 1 has leaves of its own, instead of symmetry

  bool proves_smoothness() const { return theorem == Theorem::U1 || theorem == Theorem::N1; }
};

/// A scheme of kind "uniform"; the kind is not looked at. \throws Rejected at "scheme" or "limits"
Scheme read_uniform_scheme(const nlohmann::json& json, Budget& budget);
/// \throws Rejected at "format", "scheme", "claim", "proof" or "limits"
Certificate read_certificate(const nlohmann::json& json, Budget& budget);

/// The scheme on one leaf: point parameters substituted, the others in Bernstein form in the multidegree n of the
/// greatest degrees of D and the A_i. The symbol A(z) is shifted so that its first and last coefficient are not the
/// zero polynomial.
struct LocalScheme {
  int arity = 0;
  Region box;                   ///< of the parameters that are not points
  Bernstein denominator, mask;  ///< D > 0 on the leaf; A(z), a = A / D
  Bernstein remainder;          ///< of A(z) by sigma(z)^{m+1}
  bool has_factor = false;      ///< the remainder is zero, and then
  Bernstein quotient;           ///< B(z) = p^m A(z) / sigma(z)^{m+1}, b = B / D
};

/// \throws Rejected at "denominator" when D has no proven strict sign on the leaf
LocalScheme restrict_to_leaf(const Scheme& scheme, int order, const Region& leaf, Budget& budget);

/// The integer shifts are stable: interpolatory, or linearly independent. \throws Rejected at "stability"
void prove_stability(const LocalScheme& scheme, bool interpolatory, Budget& budget);

/// Theorem U1 (C^m) and theorem U2 (not C^m) on a leaf: an estimate of the work in nanoseconds, and the proof. U1 asks for
/// sum and factor of the symbol, and for a contraction, shown by the norm of a level or by a polytope.
void prove_symbol(const LocalScheme& scheme);
double norm_work(const LocalScheme& scheme, int level);
void prove_norm(const LocalScheme& scheme, int level);
void prove_polytope_leaf(const LocalScheme& scheme, const nlohmann::json& polytope, Budget& budget);
double u2_work(const LocalScheme& scheme, const Leaf& leaf);
void prove_u2(const LocalScheme& scheme, bool interpolatory, const Leaf& leaf, Budget& budget);

/// Whether all roots of f_0 + .. + f_n z^n lie in |z| < 1 (Schur).
bool all_roots_inside(std::vector<mpz_class> f, Budget& budget);

/// Theorem N1 but for its uniform part (the leaves are those of theorem U1), and theorem N3 on one leaf.
void prove_n1(const Certificate& certificate, Budget& budget);
void prove_n3(const Certificate& certificate, const Leaf& leaf, Budget& budget);

/// The rows E_0 .. E_{2n-1} of the matrix L(gamma), the point parameters of a region being substituted.
std::vector<Stencil> matrix_rows(const Rule& rule, const Region& region, Budget& budget);
/// Polynomials on the closure of a region times one common positive number, the point variables of the region being
/// substituted, in the multidegree of their greatest degrees in the others; `box` gets the intervals of these.
Bernstein on_region(std::vector<Polynomial> polynomials, const Region& region, Region& box, Budget& budget);

/// All roots of a factor, its point parameters not yet being substituted, are less than 2^{-order} on a leaf.
void prove_dominance(const Factor& factor, int order, const Dominance& leaf, Budget& budget);
/// det(X - Y), X_ij = r_{p-j+i} for j >= i, Y_ij = r_{i+j-p} for i + j >= p (from 1, (p-1) x (p-1)), in scaled Bernstein
/// form: r_p^{p-1} prod_{i<j} (1 - z_i z_j) for the roots z_i of r. \pre p >= 2
Bernstein boundary_determinant(const Bernstein& r, Budget& budget);
/// The separation test for r(z), whose leading coefficient is positive at the midpoint: all roots satisfy |z| < 1.
void prove_separation(const Bernstein& r, int order, const Dominance& leaf, Budget& budget);

}  // namespace limes::checker
