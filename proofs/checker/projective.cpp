// SPDX-License-Identifier: MIT
//
// Theorem P1: the projective scheme of a binary mask, P_i = x_i / y_i with x = S_a^k (w P), y = S_a^k w, w = 1. Windows of
// `size` consecutive values are mapped by the sections A_e. Let K be the cone over a box of positive vectors, 1 in K, such that
// all products of `level` sections map K \ 0 into its interior and shorter ones map it to positive vectors. From y in K the points
// are mapped by M_ij = A_ij y_j / (A y)_i, whose rows sum to 1, so oscillation is multiplied by at most
// 1 - min_{i,i'} sum_j min(M_ij, M_i'j); when that is below 1 for all words and all y in K, the scheme converges.
#include "proofs/checker/projective.hpp"

#include "proofs/checker/theorems.hpp"

#include <cmath>

namespace limes::checker {
namespace {

constexpr std::size_t max_size = 64;
constexpr int max_level = 12;
constexpr unsigned fraction_bits = 64;  ///< lower bounds of the M_ij are rounded down to multiples of 2^-64

mpq_class read_number(const Json& json, const Reader& reader, const std::string& what, const std::string& step, Budget& budget) {
  const std::string& text = reader.text(json, what);
  budget.work(1000 + 2. * static_cast<double>(text.size() * text.size()));
  budget.hold(300 + static_cast<double>(text.size()));
  return read_rational(text, step);
}

/// Numerators over the least common denominator, which is returned.
mpz_class to_integers(const std::vector<mpq_class>& numbers, std::vector<mpz_class>& numerators, Budget& budget) {
  mpz_class common = 1;
  for (const auto& x : numbers) {
    budget.work(500 + 20 * limbs(common) * limbs(x));
    common = lcm(common, x.get_den());
  }
  for (const auto& x : numbers) {
    budget.work(500 + 20 * limbs(common) * limbs(x));
    budget.hold(8 * (limbs(common) + limbs(x)));
    numerators.push_back(x.get_num() * (common / x.get_den()));
  }
  return common;
}

Sections read_sections(const Json& json, Budget& budget) {
  const Reader reader(json, "scheme", "the scheme", {"kind", "name", "parameters", "arity", "first_index", "mask"});
  Sections scheme{reader.text(reader.at("name"), "name"), 0, {}, 1};
  const bool printable = std::none_of(scheme.name.begin(), scheme.name.end(), [](char c) { return c >= 0 && (c < 0x20 || c == 0x7F); });
  if (scheme.name.empty() || scheme.name.size() > 200 || !printable) reader.fail("needs a printable name of 1 to 200 bytes");
  if (reader.text(reader.at("kind"), "kind") != "uniform") reader.fail("is not of the kind uniform");
  reader.list("parameters", 0, 0);
  reader.integer(reader.at("arity"), "arity", 2, 2);
  reader.integer(reader.at("first_index"), "first_index", -1000000, 1000000);
  std::vector<mpq_class> mask;
  for (const Json& entry : reader.list("mask", 1, max_size + 1))
    mask.push_back(read_number(entry, reader, "an element of the mask", "scheme", budget));
  while (!mask.empty() && mask.back() == 0) mask.pop_back();
  while (!mask.empty() && mask.front() == 0) mask.erase(mask.begin());
  if (mask.empty()) reader.fail("has the mask zero");
  scheme.size = mask.size() - 1;
  scheme.denominator = to_integers(mask, scheme.mask, budget);
  return scheme;
}

double largest(const std::vector<mpz_class>& numbers) {
  double size = 1;
  for (const auto& x : numbers) size = std::max(size, limbs(x));
  return size;
}

/// The visitor of all products of up to `level` sections.
class Words {
 public:
  Words(const Sections& scheme, const Cone& cone, int level) : n_(scheme.size), cone_(cone), level_(level) {
    for (const int letter : {0, 1}) sections_.push_back(section(scheme, letter));
  }

  void visit(const IntegerMatrix& product, int length) {
    prove_positive(product);
    if (length == level_) {
      prove_invariant(product);
      prove_scrambling(product);
      return;
    }
    for (const IntegerMatrix& next : sections_) visit(multiply(next, product), length + 1);
  }

  Contraction result() const {
    mpq_class scale = 1;
    mpq_div_2exp(scale.get_mpq_t(), scale.get_mpq_t(), fraction_bits);
    return {1 - mpq_class(least_overlap_) * scale, 1 + 2 * mpq_class(most_negative_) * scale};
  }

 private:
  IntegerMatrix multiply(const IntegerMatrix& x, const IntegerMatrix& y) const {
    IntegerMatrix product(n_ * n_);
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t k = 0; k < n_; ++k)
        if (x[i * n_ + k] != 0)
          for (std::size_t j = 0; j < n_; ++j) product[i * n_ + j] += x[i * n_ + k] * y[k * n_ + j];
    return product;
  }

  /// min over the box of sum_k g_k z_k.
  template <class Coefficient>
  mpz_class least(Coefficient g) const {
    mpz_class sum = 0;
    for (std::size_t k = 0; k < n_; ++k) {
      const mpz_class c = g(k);
      sum += c * (c > 0 ? cone_.lower[k] : cone_.upper[k]);
    }
    return sum;
  }

  void prove_positive(const IntegerMatrix& m) const {
    for (std::size_t i = 0; i < n_; ++i)
      if (least([&](std::size_t k) { return m[i * n_ + k]; }) <= 0)
        throw Rejected{"weights", "weights of the cone are not proved to stay positive"};
  }

  /// u_i (m z)_j > l_j (m z)_i on the box: m z lies inside of the cone.
  void prove_invariant(const IntegerMatrix& m) const {
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < n_; ++j) {
        if (i == j) continue;
        const auto gap = [&](std::size_t k) {
          return mpz_class(cone_.upper[i] * m[j * n_ + k] - cone_.lower[j] * m[i * n_ + k]);
        };
        if (least(gap) <= 0) throw Rejected{"cone", "a product of sections does not map the cone into its interior"};
      }
  }

  void prove_scrambling(const IntegerMatrix& m) {
    std::vector<mpz_class> lower(n_ * n_);  // of M_ij 2^fraction_bits
    for (std::size_t i = 0; i < n_; ++i) {
      mpz_class most = 0, fewest = 0, negative = 0;
      std::vector<mpz_class> at_lower, at_upper;
      for (std::size_t k = 0; k < n_; ++k) {
        at_lower.push_back(m[i * n_ + k] * cone_.lower[k]);
        at_upper.push_back(m[i * n_ + k] * cone_.upper[k]);
        most += std::max(at_lower[k], at_upper[k]);
        fewest += std::min(at_lower[k], at_upper[k]);
      }
      for (std::size_t j = 0; j < n_; ++j) {
        // t / (t + rest), t = m_ij y_j, falls with the rest for t > 0 and grows with it for t < 0; for a fixed rest it is
        // monotone in y_j.
        const bool sign = m[i * n_ + j] >= 0;
        const mpz_class rest = sign ? mpz_class(most - std::max(at_lower[j], at_upper[j]))
                                    : mpz_class(fewest - std::min(at_lower[j], at_upper[j]));
        mpz_class& bound = lower[i * n_ + j];
        bool first = true;
        for (const mpz_class& t : {at_lower[j], at_upper[j]}) {
          mpz_class value = t << fraction_bits;
          const mpz_class sum = t + rest;
          if (sum <= 0) throw Rejected{"weights", "weights of the cone are not proved to stay positive"};
          mpz_fdiv_q(value.get_mpz_t(), value.get_mpz_t(), sum.get_mpz_t());
          if (first || value < bound) bound = value;
          first = false;
        }
        if (bound < 0) negative -= bound;
      }
      most_negative_ = std::max(most_negative_, negative);
    }
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        mpz_class overlap = 0;
        for (std::size_t k = 0; k < n_; ++k) overlap += std::min(lower[i * n_ + k], lower[j * n_ + k]);
        if (overlap <= 0) throw Rejected{"contraction", "two points of a window are not proved to share a part of their origin"};
        if (least_overlap_ < 0 || overlap < least_overlap_) least_overlap_ = overlap;
      }
  }

  std::size_t n_;
  const Cone& cone_;
  int level_;
  std::vector<IntegerMatrix> sections_;
  mpz_class least_overlap_ = -1, most_negative_ = 0;
};

}  // namespace

MaskClaim read_mask_claim(const Json& json, Budget& budget) {
  const Reader certificate(json, "format", "the certificate", {"format", "version", "scheme", "claim", "verdict", "theorem", "proof"});
  MaskClaim claim{read_sections(certificate.at("scheme"), budget), "", certificate.is_first("verdict", "certified", "refuted")};
  const Reader reader(certificate.at("claim"), "claim", "the claim", {"statement", "region"});
  claim.statement = reader.text(reader.at("statement"), "statement");
  const Reader region(reader.at("region"), "claim", "the region", {});
  return claim;
}

int smoothness_in(const std::string& statement, const std::string& prefix) {
  for (int m = 0; m <= 64; ++m)
    if (statement == prefix + "C" + std::to_string(m)) return m;
  return -1;
}

std::vector<int> read_word(const Reader& reader, const char* key, std::size_t least, std::size_t most) {
  std::vector<int> word;
  for (const Json& letter : reader.list(key, least, most)) word.push_back(reader.integer(letter, "a letter", 0, 1));
  return word;
}

IntegerMatrix section(const Sections& scheme, int letter) {
  const auto n = static_cast<long>(scheme.size);
  IntegerMatrix result;
  for (long i = 0; i < n; ++i) {
    for (long j = 0; j < n; ++j) {
      const long k = letter + 2 * j - i;
      result.push_back(k >= 0 && k <= n ? scheme.mask[static_cast<std::size_t>(k)] : mpz_class(0));
    }
  }
  return result;
}

IntegerMatrix apply_word(const Sections& scheme, const std::vector<int>& word, Budget& budget) {
  const std::size_t n = scheme.size;
  const double m = static_cast<double>(n), size = largest(scheme.mask), length = static_cast<double>(word.size());
  budget.work(length * m * m * m * (60 + 2 * length * size * size));
  budget.hold(2 * m * m * (32 + 8 * length * (size + 1)));
  IntegerMatrix product(n * n);
  for (std::size_t i = 0; i < n; ++i) product[i * n + i] = 1;
  for (const int letter : word) {
    const IntegerMatrix a = section(scheme, letter);
    IntegerMatrix next(n * n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < n; ++k)
        if (a[i * n + k] != 0)
          for (std::size_t j = 0; j < n; ++j) next[i * n + j] += a[i * n + k] * product[k * n + j];
    product = std::move(next);
  }
  return product;
}

Cone read_cone(const Reader& proof, std::size_t size, Budget& budget) {
  const Reader reader(proof.at("cone"), "proof", "the cone", {"lower", "upper"});
  std::vector<mpq_class> both;
  for (const char* key : {"lower", "upper"})
    for (const Json& entry : reader.list(key, size, size)) both.push_back(read_number(entry, reader, key, "proof", budget));
  for (std::size_t k = 0; k < size; ++k)
    if (both[k] <= 0 || both[k] >= both[size + k]) throw Rejected{"cone", "the cone needs 0 < lower < upper"};
  Cone cone;
  std::vector<mpz_class> numerators;
  to_integers(both, numerators, budget);
  const auto middle = numerators.begin() + static_cast<std::ptrdiff_t>(size);
  cone.lower.assign(numerators.begin(), middle);
  cone.upper.assign(middle, numerators.end());
  return cone;
}

Contraction prove_contraction(const Sections& scheme, const Cone& cone, int level, Budget& budget) {
  const std::size_t n = scheme.size;
  if (n < 2) throw Rejected{"scheme", "consecutive windows of a mask of two coefficients do not overlap"};
  if (*std::max_element(cone.lower.begin(), cone.lower.end()) > *std::min_element(cone.upper.begin(), cone.upper.end()))
    throw Rejected{"cone", "equal weights do not lie in the cone"};
  const double words = std::pow(2., level + 1), m = static_cast<double>(n), size = largest(scheme.mask),
               box = std::max(largest(cone.lower), largest(cone.upper)), entry = level * (size + 1);
  budget.work(words * m * m * m * (150 + 2 * entry * (size + 1) + 2 * (entry + box) * (box + 1)) +
              words * m * m * (2000 + 30 * (entry + box) * (entry + box)));
  budget.hold((level + 4) * m * m * (32 + 8 * (entry + box)));
  Words visitor(scheme, cone, level);
  IntegerMatrix identity(n * n);
  for (std::size_t i = 0; i < n; ++i) identity[i * n + i] = 1;
  visitor.visit(identity, 0);
  return visitor.result();
}

std::string mask_statement(const MaskClaim& claim, const std::string& proved, const std::string& theorem) {
  std::string name;
  for (const char c : claim.scheme.name) name += c == '"' ? '\'' : c;
  const std::string result = std::string(claim.certified ? "certified: \"" : "refuted: \"") + name + "\" is " + claim.statement;
  return result + (claim.certified ? "" : "; it is " + proved) + " (theorem " + theorem + ")";
}

std::string check_p1(const Json& json, Budget& budget) {
  const MaskClaim claim = read_mask_claim(json, budget);
  if (claim.statement != (claim.certified ? "projective C0" : "not projective C0"))
    throw Rejected{"claim", "theorem P1 certifies \"projective C0\" or refutes \"not projective C0\""};
  const Reader proof(json.at("proof"), "proof", "the proof", {"cone", "level"});
  const int level = proof.integer(proof.at("level"), "level", 1, max_level);
  prove_contraction(claim.scheme, read_cone(proof, claim.scheme.size, budget), level, budget);
  return mask_statement(claim, "projective C0", "P1");
}

}  // namespace limes::checker
