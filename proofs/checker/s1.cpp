// SPDX-License-Identifier: MIT
//
// Theorem S1 (after Dyn & Levin 1995; docs/theory.md proves this form): let the limit mask a of the masks a^(k) be C^m by
// theorem U1, let sigma^j divide all a^(k) from some level on, and c^(k) = p^j a^(k) / sigma^j, c likewise. If
// sum_k p^{(m-j)k} ||S_{c^(k)} - S_c|| is finite, then the scheme is C^m. With mu_k = cos x_k (or cosh) and
// c_i(mu) - c_i(1) = (mu - 1)^r h_i(mu), |mu_k - 1| <= kappa x_k^2 / 2 (kappa = 1, or a bound of cosh x_k), bounds of h_i give
// ||S_{c^(k)} - S_c|| <= C x_k^q, q = 2 r, x_k = theta p^{-(k+1)}: summable when q > m - j.
#include "proofs/checker/certificate.hpp"
#include "proofs/checker/json.hpp"
#include "proofs/checker/sequence.hpp"
#include "proofs/checker/theorems.hpp"

namespace limes::checker {
namespace {

struct Proof {
  int order = 0;  ///< m
  int from_level = 0, factors = 0, r = 0;
  mpq_class constant;
};

/// p numerators / sigma as identities in mu; the shift of the quotient plays no part.
std::vector<Dense> divided(std::vector<Dense> symbol, int arity, Budget& budget) {
  std::vector<Dense> quotient;
  const auto p = static_cast<std::size_t>(arity);
  for (std::size_t i = 0; i < symbol.size(); ++i) {  // from the lowest index on: sigma begins with 1
    const double size = size_of(symbol[i]);
    budget.work(arity * static_cast<double>(symbol[i].size() + 1) * (500 + 4 * size * size));
    if (i + p <= symbol.size()) {
      for (std::size_t k = 1; k < p; ++k) {
        Dense& target = symbol[i + k];
        target.resize(std::max(target.size(), symbol[i].size()));
        for (std::size_t e = 0; e < symbol[i].size(); ++e) target[e] -= symbol[i][e];
        while (!target.empty() && target.back() == 0) target.pop_back();
      }
      quotient.push_back(symbol[i]);
      for (mpq_class& c : quotient.back()) c *= arity;
    } else if (!symbol[i].empty()) {
      throw Rejected{"factor", "sigma^j does not divide the masks"};
    }
  }
  return quotient;
}

/// N with N(mu) (mu - 1)^r = p(mu).
Dense without_factor(Dense p, int r, Budget& budget) {
  for (int k = 0; k < r && !p.empty(); ++k) {
    const double size = size_of(p);
    budget.work(static_cast<double>(p.size()) * (500 + 4 * size * size));
    for (std::size_t e = p.size() - 1; e-- > 0;) p[e] += p[e + 1];  // synthetic division: p[0] becomes the remainder
    if (p[0] != 0) throw Rejected{"order", "the masks do not tend to their limit so fast"};
    p.erase(p.begin());
  }
  return p;
}

/// sum |c_i(mu) - c_i(1)| <= bound |mu - 1|^r over every residue class of i, on the range of mu.
void prove_bound(const std::vector<Dense>& numerators, const Dense& denominator, int arity, int r,
                 const Interval& range, const mpq_class& bound, Budget& budget) {
  const mpq_class d = value(denominator, 1, budget);
  if (d == 0) throw Rejected{"denominator", "the masks have no limit"};
  std::vector<Dense> family{denominator};
  for (const Dense& a : numerators) {
    const mpq_class limit = value(a, 1, budget) / d;
    Dense difference = a;
    difference.resize(std::max(a.size(), denominator.size()));
    const double product = size_of(denominator) + limbs(limit), sum = product + size_of(a);
    budget.work(static_cast<double>(difference.size()) * (500 + 4 * sum * sum));
    for (std::size_t e = 0; e < denominator.size(); ++e) difference[e] -= limit * denominator[e];
    while (!difference.empty() && difference.back() == 0) difference.pop_back();
    family.push_back(without_factor(std::move(difference), r, budget));
  }
  std::vector<std::vector<mpz_class>> rows = bernstein_rows(family, range, budget);
  const std::vector<mpz_class> below = std::move(rows.front());
  const bool negative = below.front() < 0;
  for (std::size_t residue = 0; residue < static_cast<std::size_t>(arity); ++residue) {
    for (std::size_t e = 0; e < below.size(); ++e) {
      mpz_class sum = 0;
      for (std::size_t i = 1 + residue; i < rows.size(); i += static_cast<std::size_t>(arity)) sum += abs(rows[i][e]);
      const mpz_class own = negative ? mpz_class(-below[e]) : below[e];
      budget.work(1000 + 20 * limbs(sum) + 2 * limbs(own) * limbs(bound));
      if (own <= 0) throw Rejected{"denominator", "the masks from step from_level on may have a pole"};
      if (mpq_class(sum) > bound * own)
        throw Rejected{"bound", "the constant does not bound the masks' distance from their limit"};
    }
  }
}

/// The embedded certificate of the limit scheme: of theorem U1, and about the limit of these masks.
void check_limit(const Json& json, const Sequence& sequence, int order, Budget& budget) {
  if (!json.is_object() || !json.contains("theorem") || json["theorem"] != "U1")
    throw Rejected{"limit", "the limit scheme needs a certificate of theorem U1"};
  const Certificate limit = read_certificate(json, budget);
  if (!limit.certified || limit.negated || limit.order != order || !limit.scheme.parameters.empty() ||
      limit.scheme.arity != sequence.arity)
    throw Rejected{"limit", "the certificate of the limit scheme states something else"};
  const auto trimmed = [](std::vector<mpq_class> mask) {
    while (!mask.empty() && mask.back() == 0) mask.pop_back();
    while (!mask.empty() && mask.front() == 0) mask.erase(mask.begin());
    return mask;
  };
  std::vector<mpq_class> stated, own;
  const auto constant_value = [](const Polynomial& p) { return p.empty() ? mpq_class(0) : p.begin()->second; };
  for (const Polynomial& p : limit.scheme.mask)
    stated.push_back(constant_value(p) / constant_value(limit.scheme.denominator));
  const mpq_class d = value(sequence.mask.denominator, 1, budget);
  for (const Dense& a : sequence.mask.numerators) own.push_back(value(a, 1, budget) / d);
  if (trimmed(stated) != trimmed(own))
    throw Rejected{"limit", "the embedded certificate is about another mask than the limit"};
  check_smoothness(json, budget);
}

}  // namespace

std::string check_s1(const Json& json, Budget& budget) {
  const SequenceCertificate certificate = read_sequence_certificate(json, budget);
  const Sequence& sequence = certificate.sequence;
  Proof proof;
  while (proof.order <= 64 && certificate.statement != "C" + std::to_string(proof.order)) ++proof.order;
  if (proof.order > 64) throw Rejected{"claim", "theorem S1 proves C<m> with m from 0 to 64"};
  if (!certificate.certified) throw Rejected{"claim", "theorem S1 refutes nothing"};

  const Reader reader(json["proof"], "proof", "the proof", {"from_level", "factors", "order", "constant", "limit"});
  proof.from_level = reader.integer(reader.at("from_level"), "from_level", 0, 128);
  proof.factors = reader.integer(reader.at("factors"), "factors", 0, proof.order);
  const int q = reader.integer(reader.at("order"), "order", 1, 200);
  if (q % 2 != 0) reader.fail("needs an even order");
  proof.r = q / 2;
  const std::string& constant = reader.text(reader.at("constant"), "constant");
  budget.work(1000 + 2. * static_cast<double>(constant.size() * constant.size()));
  proof.constant = read_rational(constant, "proof");
  if (q <= proof.order - proof.factors) throw Rejected{"order", "the masks tend to their limit too slowly"};

  require_defined(sequence, certificate.angles, proof.from_level, budget);
  std::vector<Dense> symbol = sequence.mask.numerators;
  for (int k = 0; k < proof.factors; ++k) symbol = divided(std::move(symbol), sequence.arity, budget);

  const Interval range = tail_range(sequence, certificate.angles, proof.from_level, budget);
  const mpq_class kappa = sequence.hyperbolic ? range.upper.value : mpq_class(1);
  mpq_class bound = proof.constant;  // C (2 / kappa)^r
  budget.work(100. * proof.r * proof.r * limbs(kappa) * limbs(kappa) + 1000);
  for (int k = 0; k < proof.r; ++k) bound *= 2 / kappa;
  prove_bound(symbol, sequence.mask.denominator, sequence.arity, proof.r, range, bound, budget);
  check_limit(reader.at("limit"), sequence, proof.order, budget);
  return "certified: " + shown(sequence) + " is " + certificate.statement + shown_angles(sequence, certificate.angles) +
         " (theorem S1, the masks tend to their limit like x^" + std::to_string(q) + ")";
}

}  // namespace limes::checker
