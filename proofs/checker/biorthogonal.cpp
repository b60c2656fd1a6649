// SPDX-License-Identifier: MIT
//
// Theorem B1: four filters p, a, b, q with AP = I, AQ = 0, BP = 0, BQ = I, where columns of P and Q advance by 2 and rows
// of A and B by 2 from column `shift` on. On the integers this is [A; B][P Q] = I for matrices of 2 x 2 blocks that are
// Laurent polynomials, so [P Q][A; B] = I too, and both hold modulo z^n - 1: for circulant matrices of every size n.
// G(x) = g_0 + 2 sum_d g_d T_d(x), g_d = sum_i f_i f_{i + 2d}, is the symbol of P^T P (f = p), A A^T (f = a), B B^T (f = b)
// at frequency arccos x: its range on [-1, 1] gives the least and greatest squared singular values.
#include "proofs/checker/certificate.hpp"
#include "proofs/checker/json.hpp"
#include "proofs/checker/theorems.hpp"

#include <algorithm>

namespace limes::checker {
namespace {

using Coefficients = std::vector<mpz_class>;

constexpr std::size_t max_length = 512;

/// numerators / denominator; also the coefficients of G.
struct Filter {
  Coefficients numerators;
  mpz_class denominator;
  double limbs = 1;  ///< of the largest number, at least
  std::size_t size() const { return numerators.size(); }
};

mpq_class read_number(const Json& json, const Reader& reader, const char* what, Budget& budget) {
  const std::string& text = reader.text(json, what);
  budget.work(1000 + 2. * static_cast<double>(text.size() * text.size()));
  budget.hold(300 + static_cast<double>(text.size()));
  return read_rational(text, "proof");
}

Filter read_filter(const Reader& reader, const char* key, Budget& budget) {
  std::vector<mpq_class> entries;
  Filter filter{{}, 1};
  for (const Json& entry : reader.list(key, 2, max_length)) {
    entries.push_back(read_number(entry, reader, key, budget));
    const mpz_class& d = entries.back().get_den();
    budget.work(500 + 20 * limbs(filter.denominator) * limbs(d));
    filter.denominator = lcm(filter.denominator, d);
  }
  filter.limbs = limbs(filter.denominator);
  for (const auto& x : entries) {
    budget.work(500 + 20 * filter.limbs * (limbs(x) + filter.limbs));
    budget.hold(8 * (filter.limbs + limbs(x)));
    filter.numerators.push_back(x.get_num() * (filter.denominator / x.get_den()));
    filter.limbs = std::max(filter.limbs, limbs(filter.numerators.back()));
  }
  return filter;
}

struct Bounds {
  mpq_class lower, upper;
};

Bounds read_bounds(const Reader& reader, const char* key, Budget& budget) {
  const Json& list = reader.list(key, 2, 2);
  Bounds bounds{read_number(list[0], reader, key, budget), read_number(list[1], reader, key, budget)};
  if (bounds.lower > bounds.upper) reader.fail("has a lower above an upper bound of " + std::string(key));
  return bounds;
}

/// sum_i x_{i + offset} y_i times both denominators, entries outside being 0.
mpz_class correlation(const Filter& x, const Filter& y, long offset) {
  mpz_class sum = 0;
  const long n = static_cast<long>(x.size());
  for (long i = std::max(0L, -offset); i < n && i + offset < n; ++i)
    sum += x.numerators[static_cast<std::size_t>(i + offset)] * y.numerators[static_cast<std::size_t>(i)];
  return sum;
}

/// Nanoseconds of all correlations.
double correlation_work(const Filter& x, const Filter& y) {
  return static_cast<double>(x.size() * y.size()) * (100 + 2 * x.limbs * y.limbs);
}

/// Entry (r, r - lag) of the product of the rows y and the columns x is that of the identity times `diagonal`, for all lags
/// at which they overlap, and for lag 0.
void prove_product(const Filter& y, const Filter& x, long shift, int diagonal, const char* name, Budget& budget) {
  budget.work(correlation_work(x, y));
  const long reach = static_cast<long>(x.size()) + std::abs(shift);
  for (long lag = -reach; lag <= reach; ++lag) {
    const mpz_class one = x.denominator * y.denominator;
    if (correlation(x, y, shift + 2 * lag) != (lag == 0 ? mpz_class(diagonal * one) : 0))
      throw Rejected{"biorthogonality", std::string(name) + " does not hold at lag " + std::to_string(lag)};
  }
}

/// g_0, 2 g_1, 2 g_2, ..: the coefficients of G in Chebyshev polynomials.
Filter gram_symbol(const Filter& f, Budget& budget) {
  budget.work(correlation_work(f, f));
  Filter g{{}, f.denominator * f.denominator, 2 * f.limbs + 2};
  for (long lag = 0; 2 * lag < static_cast<long>(f.size()); ++lag)
    g.numerators.push_back(correlation(f, f, 2 * lag) * (lag == 0 ? 1 : 2));
  return g;
}

/// G(x), by T_{d+1} = 2 x T_d - T_{d-1} from the highest coefficient on (Clenshaw).
mpq_class value(const Filter& g, const mpq_class& x, Budget& budget) {
  const auto n = static_cast<double>(g.size());
  const double size = g.limbs + n * limbs(x);
  budget.work(n * (1000 + 20 * size * size));
  mpq_class next = 0, after = 0;
  for (std::size_t d = g.size(); d-- > 1;) {
    mpq_class current = g.numerators[d] + 2 * x * next - after;
    after = std::move(next);
    next = std::move(current);
  }
  const mpq_class scaled = g.numerators[0] + x * next - after;
  return scaled / g.denominator;
}

/// sum_d c_d T_d(x) in powers of x.
Coefficients in_powers(const Coefficients& c) {
  Coefficients result(c.size()), before, current{1};
  for (std::size_t d = 0; d < c.size(); ++d) {
    for (std::size_t i = 0; i < current.size(); ++i) result[i] += c[d] * current[i];
    Coefficients next(current.size() + 1);  // T_{d+1}
    for (std::size_t i = 0; i < current.size(); ++i) next[i + 1] = current[i] * (d == 0 ? 1 : 2);
    for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
    before = std::move(current);
    current = std::move(next);
  }
  return result;
}

int sign_at(const Coefficients& f, int x) {  // x = 1 or -1
  mpz_class sum = 0;
  for (std::size_t i = 0; i < f.size(); ++i) sum += x < 0 && i % 2 == 1 ? mpz_class(-f[i]) : f[i];
  return sgn(sum);
}

void make_primitive(Coefficients& f) {
  while (!f.empty() && f.back() == 0) f.pop_back();
  mpz_class content = 0;
  for (const auto& c : f) content = gcd(content, c);
  if (content > 1)
    for (auto& c : f) c /= content;
}

/// f > 0 on [-1, 1]: positive at both ends, and by Sturm's theorem without a root in between.
bool is_positive(Coefficients f, Budget& budget) {
  make_primitive(f);
  if (f.empty() || sign_at(f, 1) <= 0 || sign_at(f, -1) <= 0) return false;
  Coefficients g;
  for (std::size_t i = 1; i < f.size(); ++i) g.push_back(f[i] * static_cast<unsigned long>(i));
  make_primitive(g);
  int variations[2] = {0, 0}, signs[2] = {1, 1};
  while (!g.empty()) {
    for (const int end : {0, 1}) {
      const int sign = sign_at(g, end == 0 ? -1 : 1);
      if (sign != 0 && sign != signs[end]) ++variations[end], signs[end] = sign;
    }
    // The remainder of lc(g)^{2k} f by g, its sign changed: a positive multiple of Sturm's.
    Coefficients rest = std::move(f);
    const std::size_t excess = rest.size() - g.size() + 1;
    for (std::size_t step = 0; rest.size() >= g.size(); ++step) {
      double size = 1;
      for (const auto& c : rest) size = std::max(size, checker::limbs(c));
      budget.work(static_cast<double>(rest.size()) * (300 + 4 * size * checker::limbs(g.back())));
      const mpz_class factor = rest.back();
      const std::size_t shift = rest.size() - g.size();
      for (auto& c : rest) c *= g.back();
      for (std::size_t i = 0; i < g.size(); ++i) rest[i + shift] -= factor * g[i];
      rest.pop_back();
    }
    if (excess % 2 == 0 || g.back() > 0)
      for (auto& c : rest) c = -c;
    make_primitive(rest);
    f = std::move(g);
    g = std::move(rest);
  }
  return variations[0] == variations[1];
}

/// sign (bound - G) >= 0 on [-1, 1]: with coefficients rounded to multiples of a unit, whose error is added to the bound.
bool is_bound(const Filter& g, const mpq_class& bound, int sign, Budget& budget) {
  const auto n = static_cast<double>(g.size());
  mpq_class largest = abs(bound);
  for (const auto& c : g.numerators) largest = std::max<mpq_class>(largest, mpq_class(abs(c), g.denominator));
  if (largest == 0) return true;
  // The unit 2^-bits is about 2^-192 times the largest number.
  const long bits = 192 + static_cast<long>(mpz_sizeinbase(largest.get_den_mpz_t(), 2)) -
                    static_cast<long>(mpz_sizeinbase(largest.get_num_mpz_t(), 2));
  const auto in_units = [&](mpz_class numerator, mpz_class denominator) {  // rounded down
    (bits >= 0 ? numerator : denominator) <<= static_cast<unsigned long>(std::abs(bits));
    mpz_class result;
    mpz_fdiv_q(result.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
    return result;
  };
  budget.work(n * (1000 + 20 * g.limbs * g.limbs) + n * n * n * 60);
  Coefficients difference;
  for (const auto& c : g.numerators) difference.push_back(-sign * in_units(c, g.denominator));
  // Rounding down the bound and the n coefficients changes the difference by less than n + 1 units, either way.
  difference[0] += sign * in_units(bound.get_num(), bound.get_den()) - static_cast<unsigned long>(g.size() + 1);
  return is_positive(in_powers(difference), budget);
}

/// The extreme value of G on [-1, 1], greatest (sign 1) or least (sign -1), lies within the bounds: at a witness it reaches
/// the inner one, nowhere it exceeds the outer one.
void prove_extreme(const Filter& f, const Bounds& bounds, const mpq_class& witness, int sign, const char* name,
                   Budget& budget) {
  const Filter g = gram_symbol(f, budget);
  if (abs(witness) > 1) throw Rejected{"singular_values", std::string(name) + ": the witness is not in [-1, 1]"};
  const mpq_class at_witness = value(g, witness, budget);
  if (sign > 0 ? at_witness < bounds.lower : at_witness > bounds.upper)
    throw Rejected{"singular_values", std::string(name) + ": the value at the witness does not reach the bound"};
  if (!is_bound(g, sign > 0 ? bounds.upper : bounds.lower, sign, budget))
    throw Rejected{"singular_values", std::string(name) + ": not proved to be a bound everywhere"};
}

std::string shown(const Bounds& bounds) {
  const auto text = [](const mpq_class& x) {
    const std::string full = x.get_str();
    return full.size() <= 40 ? full : full.substr(0, 18) + "..." + full.substr(full.size() - 18);
  };
  return "[" + text(bounds.lower) + ", " + text(bounds.upper) + "]";
}

}  // namespace

std::string check_biorthogonality(const Json& json, Budget& budget) {
  const Reader top(json, "format", "the certificate",
                   {"format", "version", "theorem", "verdict", "scheme", "claim", "proof"});
  if (top.text(top.at("verdict"), "verdict") != "certified") top.fail("needs the verdict certified");
  const Reader scheme(top.at("scheme"), "scheme", "the scheme",
                      {"kind", "name", "parameters", "arity", "first_index", "mask"});
  if (scheme.text(scheme.at("kind"), "kind") != "uniform") scheme.fail("needs the kind uniform");
  scheme.list("parameters", 0, 0);
  scheme.integer(scheme.at("arity"), "arity", 2, 2);
  scheme.integer(scheme.at("first_index"), "first_index", -1000000, 1000000);
  const std::string& name = scheme.text(scheme.at("name"), "name");
  if (name.empty() || name.size() > 200 ||
      std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < 32 || c == 127; }))
    scheme.fail("needs a name of 1 to 200 bytes without control characters");
  const Filter mask = read_filter(scheme, "mask", budget);

  const Reader claim(top.at("claim"), "claim", "the claim", {"statement", "filters", "squares"});
  if (claim.text(claim.at("statement"), "statement") != "biorthogonal") claim.fail("needs the statement biorthogonal");
  const Reader filters(claim.at("filters"), "claim", "the filters", {"p", "a", "b", "q", "shift"});
  const Filter p = read_filter(filters, "p", budget), a = read_filter(filters, "a", budget),
               b = read_filter(filters, "b", budget), q = read_filter(filters, "q", budget);
  if (p.size() % 2 != 0 || a.size() != p.size() || b.size() != p.size() || q.size() != p.size())
    filters.fail("need one even length");
  const int shift = filters.integer(filters.at("shift"), "shift", -2000, 2000);
  if (shift % 2 != 0) filters.fail("need an even shift");
  const Reader squares(claim.at("squares"), "claim", "the squares",
                       {"orthogonality_error", "sigma_min_p", "norm_a", "norm_b"});
  const Bounds error = read_bounds(squares, "orthogonality_error", budget),
               least = read_bounds(squares, "sigma_min_p", budget), norm_a = read_bounds(squares, "norm_a", budget),
               norm_b = read_bounds(squares, "norm_b", budget);
  const Reader proof(top.at("proof"), "proof", "the proof", {"sigma_min_p", "norm_a", "norm_b"});

  if (mask.size() > p.size()) throw Rejected{"mask", "p is shorter than the mask"};
  for (std::size_t i = 0; i < p.size(); ++i) {
    const mpz_class entry = i < mask.size() ? mask.numerators[i] : mpz_class(0);
    if (entry * p.denominator != p.numerators[i] * mask.denominator)
      throw Rejected{"mask", "p is not the mask with zeros appended"};
  }
  prove_product(a, p, shift, 1, "AP = I", budget);
  prove_product(a, q, shift, 0, "AQ = 0", budget);
  prove_product(b, p, shift, 0, "BP = 0", budget);
  prove_product(b, q, shift, 1, "BQ = I", budget);

  budget.work(2 * correlation_work(p, q) + static_cast<double>(p.size()) * 10 * p.limbs * q.limbs * p.limbs * q.limbs);
  mpz_class sum = 0;
  for (long lag = -static_cast<long>(p.size()); lag <= static_cast<long>(p.size()); ++lag) {
    const mpz_class entry = correlation(p, q, 2 * lag);
    sum += entry * entry;
  }
  const mpz_class unit = p.denominator * q.denominator;
  const mpz_class square = unit * unit;
  if (sum * error.lower.get_den() < error.lower.get_num() * square ||
      sum * error.upper.get_den() > error.upper.get_num() * square)
    throw Rejected{"orthogonality_error", "||P^T q||^2 is not between its bounds"};
  prove_extreme(p, least, read_number(proof.at("sigma_min_p"), proof, "sigma_min_p", budget), -1, "sigma_min(P)",
                budget);
  prove_extreme(a, norm_a, read_number(proof.at("norm_a"), proof, "norm_a", budget), 1, "||A||", budget);
  prove_extreme(b, norm_b, read_number(proof.at("norm_b"), proof, "norm_b", budget), 1, "||B||", budget);
  std::string label = "\"";
  for (const char c : name) label += c == '"' ? '\'' : c;
  return "certified: filters of length " + std::to_string(p.size()) + " and shift " + std::to_string(shift) + " for " +
         label +
         "\" satisfy AP = I, AQ = 0, BP = 0, BQ = I and PA + QB = I on the integers and for circulant matrices of "
         "every size; "
         "||P^T q||^2 in " +
         shown(error) + ", sigma_min(P)^2 in " + shown(least) + ", ||A||^2 in " + shown(norm_a) + ", ||B||^2 in " +
         shown(norm_b) + " (theorem B1)";
}

}  // namespace limes::checker
