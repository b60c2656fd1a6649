// SPDX-License-Identifier: MIT
//
// Theorem U3: let a(1) = p and a = sigma^k p^{-(k-1)} b, k >= 1. Limits of S_a have every Hoelder exponent less than
// (k-1) - log_p JSR(B_0 .. B_{p-1}) when this is positive; and none greater, if the integer shifts are stable and sigma^{k+1} does not divide a.
// A bound c/d of the exponent is shown by powers: JSR^d <= p^{(k-1) d - c}, no logarithm is taken.
#include "proofs/checker/certificate.hpp"
#include "proofs/checker/json.hpp"
#include "proofs/checker/polytope.hpp"
#include "proofs/checker/theorems.hpp"

namespace limes::checker {
namespace {

/// A positive number between two of mantissa * 2^exponent; exact until the mantissa gets longer than 512 bits.
struct Enclosed {
  mpz_class lower, upper, exponent;

  void shorten() {
    const std::size_t bits = mpz_sizeinbase(upper.get_mpz_t(), 2);
    if (bits <= 512) return;
    const std::size_t excess = bits - 512;
    mpz_fdiv_q_2exp(lower.get_mpz_t(), lower.get_mpz_t(), excess);
    mpz_cdiv_q_2exp(upper.get_mpz_t(), upper.get_mpz_t(), excess);
    exponent += static_cast<unsigned long>(excess);
  }
};

Enclosed power(const mpz_class& base, const mpz_class& exponent) {
  Enclosed result{1, 1, 0}, square{base, base, 0};
  const auto multiply = [](Enclosed& x, const Enclosed& y) {
    x.lower *= y.lower;
    x.upper *= y.upper;
    x.exponent += y.exponent;
    x.shorten();
  };
  square.shorten();
  const std::size_t bits = mpz_sizeinbase(exponent.get_mpz_t(), 2);
  for (std::size_t i = bits; i-- > 0;) {
    const Enclosed copy = result;
    multiply(result, copy);
    if (mpz_tstbit(exponent.get_mpz_t(), i) != 0) multiply(result, square);
  }
  return result;
}

/// x.upper 2^x.exponent <= y.lower 2^y.exponent.
bool proves_at_most(const Enclosed& x, const Enclosed& y) {
  mpz_class left = x.upper, right = y.lower, shift = x.exponent - y.exponent;
  const mpz_class size = static_cast<unsigned long>(mpz_sizeinbase(left.get_mpz_t(), 2) + mpz_sizeinbase(right.get_mpz_t(), 2));
  if (left < 1 || right < 1) return false;
  if (abs(shift) > size + 2) return shift < 0;
  if (shift >= 0)
    left <<= shift.get_ui();
  else
    right <<= mpz_class(-shift).get_ui();
  return left <= right;
}

/// (x / y)^d <= p^e. \pre x, y > 0
bool power_at_most(const mpz_class& x, const mpz_class& y, const mpz_class& d, int p, const mpz_class& e, Budget& budget) {
  budget.work(1e6 + 5e3 * static_cast<double>(mpz_sizeinbase(d.get_mpz_t(), 2) + mpz_sizeinbase(e.get_mpz_t(), 2)) +
              50 * limbs(x) * limbs(x) + 50 * limbs(y) * limbs(y));
  Enclosed left = power(x, d), right = power(y, d);
  Enclosed& side = e >= 0 ? right : left;
  const Enclosed factor = power(p, abs(e));
  side.lower *= factor.lower;
  side.upper *= factor.upper;
  side.exponent += factor.exponent;
  return proves_at_most(left, right);
}

/// (B_e)_{ij} = b_{e + pj - i} on {0, .., max(1, ceil(N / (p-1))) - 1}, verified to be invariant.
std::vector<RationalMatrix> sections(const LocalScheme& scheme, Budget& budget) {
  const auto& b = scheme.quotient.coefficients;
  const mpz_class& denominator = scheme.denominator.coefficients.front();
  const long p = scheme.arity, count = static_cast<long>(b.size()), n = std::max(1L, (count - 1 + p - 2) / (p - 1));
  if (n > 64) throw Rejected{"limits", "the sections have more than 64 rows"};
  std::vector<RationalMatrix> result(static_cast<std::size_t>(p), RationalMatrix(static_cast<std::size_t>(n), static_cast<std::size_t>(n)));
  for (long e = 0; e < p; ++e) {
    for (long i = 0; i < n; ++i) {
      for (long j = -count - n; j <= count + n; ++j) {
        const long k = e + p * j - i;
        if (k < 0 || k >= count || b[static_cast<std::size_t>(k)] == 0) continue;
        if (j < 0 || j >= n) throw Rejected{"sections", "the section is not invariant"};
        const mpz_class& numerator = b[static_cast<std::size_t>(k)];
        budget.work(500 + 20 * limbs(numerator) * limbs(denominator));
        mpq_class entry(numerator, denominator);
        entry.canonicalize();
        result[static_cast<std::size_t>(e)].at(static_cast<std::size_t>(i), static_cast<std::size_t>(j)) = std::move(entry);
      }
    }
  }
  return result;
}

/// JSR <= ||S_b^l||^{1/l} < upper, since the rows of products of l sections are parts of rows of S_b^l; and a word for the lower bound.
void prove_radius_by_norm(LocalScheme scheme, const std::vector<RationalMatrix>& family, const RadiusBounds& claim, const Json& json, Budget& budget) {
  const Reader proof(json, "proof", "the proof of the radius", {"word", "level"});
  if (!claim.polynomial.empty()) proof.fail("has no exact radius");
  const int level = proof.integer(proof.at("level"), "the level", 1, 24);
  budget.work(20 * (limbs(scheme.quotient) + limbs(scheme.denominator)) * static_cast<double>(scheme.quotient.count()) * limbs(claim.upper));
  for (mpz_class& c : scheme.quotient.coefficients) c *= claim.upper.get_den();
  for (mpz_class& c : scheme.denominator.coefficients) c *= claim.upper.get_num();
  budget.work(norm_work(scheme, level));
  prove_norm(scheme, level);
  prove_radius_at_least(family, proof.at("word"), claim.lower, budget);
}

struct ExponentClaim {
  Region region;
  mpq_class lower;
  std::optional<mpq_class> upper;
  std::vector<mpq_class> polynomial;  ///< the exponent is (k-1) - log_p of its root between the bounds of the radius
};

ExponentClaim read_claim(const Json& json, const Scheme& scheme, Budget& budget) {
  const bool bounded = json.is_object() && json.contains("upper");
  std::vector<std::string> keys{"statement", "region", "lower"};
  if (bounded) keys.emplace_back("upper");
  const bool exact = bounded && json.contains("polynomial");
  if (exact) keys.emplace_back("polynomial");
  const Reader claim(json, "claim", "the claim", keys);
  claim.is_first("statement", "Hoelder exponent", "Hoelder exponent");
  ExponentClaim result{claim.region(scheme.parameters, budget), read_number(claim.at("lower"), "claim", "lower", budget), {}, {}};
  for (const Interval& interval : result.region)
    if (!interval.is_point()) claim.fail("needs a region that is one point");
  if (bounded) result.upper = read_number(claim.at("upper"), "claim", "upper", budget);
  if (exact)
    for (const Json& c : claim.list("polynomial", 2, 65)) result.polynomial.push_back(read_number(c, "claim", "the polynomial", budget));
  return result;
}

}  // namespace

std::string check_hoelder_exponent(const Json& json, Budget& budget) {
  const Reader reader(json, "format", "the certificate", {"format", "version", "scheme", "claim", "theorem", "proof"});
  if (!reader.at("scheme").is_object() || !reader.at("scheme").contains("kind") || reader.at("scheme")["kind"] != "uniform")
    throw Rejected{"scheme", "the scheme is not of kind uniform"};
  const Scheme scheme = read_uniform_scheme(reader.at("scheme"), budget);
  const ExponentClaim claim = read_claim(reader.at("claim"), scheme, budget);
  std::vector<std::string> keys{"order", "radius_lower", "radius_upper", "radius"};
  if (claim.upper) keys.emplace_back("stability");
  const Reader proof(reader.at("proof"), "proof", "the proof", keys);
  const int k = proof.integer(proof.at("order"), "the order", 1, 64);
  const RadiusBounds radius{read_number(proof.at("radius_lower"), "proof", "radius_lower", budget),
                            read_number(proof.at("radius_upper"), "proof", "radius_upper", budget),
                            claim.polynomial};
  if (radius.upper <= 0 || (claim.upper && radius.lower <= 0)) proof.fail("needs positive bounds of the radius");

  const LocalScheme local = restrict_to_leaf(scheme, k - 1, claim.region, budget);
  const mpz_class& denominator = local.denominator.coefficients.front();
  mpz_class sum = 0;
  for (const mpz_class& c : local.mask.coefficients) sum += c;
  if (sum != scheme.arity * denominator) throw Rejected{"sum", "a(1) is not p"};
  if (!local.has_factor) throw Rejected{"factor", "sigma^k does not divide the symbol"};
  if (claim.upper) {
    prove_stability(local, proof.is_first("stability", "interpolatory", "linear-independence"), budget);
    if (restrict_to_leaf(scheme, k, claim.region, budget).has_factor)
      throw Rejected{"factor", "an upper bound needs the greatest k such that sigma^k divides the symbol"};
  }
  const Json& radius_proof = proof.at("radius");
  if (radius_proof.is_object() && radius_proof.contains("level"))
    prove_radius_by_norm(local, sections(local, budget), radius, radius_proof, budget);
  else
    prove_radius(sections(local, budget), radius, radius_proof, budget);

  if (claim.lower <= 0) throw Rejected{"exponent", "the lower bound is not positive"};
  const auto exponent = [&](const mpq_class& bound) { return mpz_class((k - 1) * bound.get_den() - bound.get_num()); };
  const auto fits = [](const mpq_class& bound) { return mpz_sizeinbase(bound.get_num_mpz_t(), 2) + mpz_sizeinbase(bound.get_den_mpz_t(), 2) <= 600; };
  if (!fits(claim.lower) || (claim.upper && !fits(*claim.upper))) throw Rejected{"limits", "a bound of the exponent has more than 600 bits"};
  if (!power_at_most(radius.upper.get_num(), radius.upper.get_den(), claim.lower.get_den(), scheme.arity, exponent(claim.lower), budget))
    throw Rejected{"exponent", "the lower bound does not follow from the bound of the radius"};
  // p^e <= lower^d is (1 / lower)^d <= p^{-e}.
  if (claim.upper && !power_at_most(radius.lower.get_den(), radius.lower.get_num(), claim.upper->get_den(), scheme.arity,
                                    -exponent(*claim.upper), budget))
    throw Rejected{"exponent", "the upper bound does not follow from the bound of the radius"};
  std::string where;
  for (std::size_t v = 0; v < claim.region.size(); ++v)
    where += (v == 0 ? " for " : ", ") + scheme.parameters[v] + " = " + claim.region[v].text.substr(0, 80);
  return "certified: the Hoelder exponent of " + checker::quoted(scheme.name) + where + " is at least " + claim.lower.get_str() +
         (claim.upper ? " and at most " + claim.upper->get_str() : "") +
         (claim.polynomial.empty() ? "" : ", exactly " + std::to_string(k - 1) + " - log_" + std::to_string(scheme.arity) + " of a root of the polynomial") +
         " (theorem U3)";
}

}  // namespace limes::checker
