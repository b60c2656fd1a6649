// SPDX-License-Identifier: MIT
//
// A polytope norm in which the difference scheme contracts. On the closed leaf b = B / D with Bernstein coefficients
// B_I, D_I > 0, so at every point b is a convex combination of the B_I / D_I, and so are its finite sections, with the
// same weights. A bound below 1 of the norms of all M_{I,e}, block by block in a basis in which they are block triangular,
// therefore makes all products of sections tend to 0 at every point of the leaf. With two coefficients I the sections are those at some point of
// the segment between the two families, and norms that change along it do as well.
#include "proofs/checker/certificate.hpp"
#include "proofs/checker/json.hpp"
#include "proofs/checker/polytope.hpp"

namespace limes::checker {
namespace {

/// (M_{I,e})_{ij} = B_{e + pj - i, I} / D_I for i, j in R = {0, .., size - 1}. Scaled Bernstein coefficients have one
/// binomial factor for both.
RationalMatrix section(const LocalScheme& scheme, std::size_t size, std::size_t place, int letter) {
  const Bernstein& b = scheme.quotient;
  const long n = static_cast<long>(size), count = static_cast<long>(b.count());
  RationalMatrix result(size, size);
  for (long i = 0; i < n; ++i) {
    // R is invariant: B_{e + pj - i} = 0 for i in R and every j outside of R.
    for (long j = -count - n; j <= count + n; ++j) {
      const long k = letter + scheme.arity * j - i;
      if (k < 0 || k >= count) continue;
      const mpz_class& entry = b.coefficients[static_cast<std::size_t>(k) * b.size() + place];
      if (j >= 0 && j < n) {
        mpq_class& x = result.at(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
        x = mpq_class(entry, scheme.denominator.coefficients[place]);
        x.canonicalize();
      } else if (entry != 0) {
        throw Rejected{"polytope", "the section is not invariant"};
      }
    }
  }
  return result;
}

}  // namespace

void prove_polytope_leaf(const LocalScheme& scheme, const Json& polytope, Budget& budget) {
  const bool moving = polytope.is_object() && polytope.contains("moving");
  const char* kind = moving ? "moving" : "norm";
  const Reader reader(polytope, "proof", "the polytope", {"bound", kind});
  const std::string& text = reader.text(reader.at("bound"), "bound");
  budget.work(2000 + 2. * static_cast<double>(text.size()) * static_cast<double>(text.size()));
  const mpq_class bound = read_rational(text, "proof");
  if (bound >= 1) throw Rejected{"polytope", "the bound is not below 1"};
  if (scheme.quotient.count() == 0) return;  // b = 0
  for (const auto& d : scheme.denominator.coefficients)
    if (d <= 0) throw Rejected{"denominator", "a polytope needs positive Bernstein coefficients of the denominator"};

  const std::size_t width = scheme.quotient.count() - 1, q = static_cast<std::size_t>(scheme.arity - 1);
  const std::size_t size = std::max<std::size_t>(1, (width + q - 1) / q), places = scheme.denominator.size();
  const auto n = static_cast<double>(size), p = static_cast<double>(scheme.arity);
  const double entry = limbs(scheme.quotient) + limbs(scheme.denominator);
  if (size > 64 || places > 32) throw Rejected{"limits", "a polytope norm of such a size"};
  budget.work(static_cast<double>(places) * p * n * (4 * n + static_cast<double>(width)) * (500 + 20 * entry * entry));
  budget.hold(static_cast<double>(places) * p * n * n * (64 + 8 * entry));
  std::vector<RationalMatrix> family;
  for (std::size_t place = 0; place < places; ++place)
    for (int e = 0; e < scheme.arity; ++e) family.push_back(section(scheme, size, place, e));
  if (!moving) return prove_polytope_norm(family, bound, reader.at(kind), budget);
  if (places != 2) throw Rejected{"polytope", "a moving polytope needs sections that are affine in one parameter"};
  prove_moving_norm(family, bound, reader.at(kind), budget);
}

}  // namespace limes::checker
