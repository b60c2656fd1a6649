// SPDX-License-Identifier: MIT
//
// Nonstationary schemes: reading, ranges of mu by Taylor series, and where the masks are defined.
#include "proofs/checker/sequence.hpp"

#include "proofs/checker/bernstein.hpp"
#include "proofs/checker/json.hpp"

namespace limes::checker {
namespace {

constexpr unsigned long grid_bits = 320;

/// The nearest multiple of 2^-grid_bits below or above.
mpq_class on_grid(const mpq_class& x, bool up) {
  const mpz_class scaled = x.get_num() << grid_bits;
  mpz_class quotient;
  if (up)
    mpz_cdiv_q(quotient.get_mpz_t(), scaled.get_mpz_t(), x.get_den().get_mpz_t());
  else
    mpz_fdiv_q(quotient.get_mpz_t(), scaled.get_mpz_t(), x.get_den().get_mpz_t());
  mpq_class result(quotient, mpz_class(1) << grid_bits);
  result.canonicalize();
  return result;
}

struct Bounds {
  mpq_class lower, upper;
};

/// Of cos x (cosh x) for x >= 0 on the grid, by the terms t_n = x^{2n}/(2n)! with outward rounding. The partial sums of the
/// cosine are below it after odd, above it after even n. Those of cosh are below it, by at most t_n once x^2 <= (2n+1)(2n+2)/2.
Bounds bounds(const mpq_class& x, bool hyperbolic, Budget& budget) {
  budget.work(5e5 + 5e4 * x.get_d());
  const mpq_class square = x * x, tiny(1, mpz_class(1) << (grid_bits - 20));
  Bounds result{1, 1}, sum{1, 1}, term{1, 1};
  for (unsigned long n = 1;; ++n) {
    const mpq_class factor = square / ((2 * n - 1) * (2 * n));
    term = {on_grid(term.lower * factor, false), on_grid(term.upper * factor, true)};
    if (hyperbolic || n % 2 == 0)
      sum = {sum.lower + term.lower, sum.upper + term.upper};
    else
      sum = {sum.lower - term.upper, sum.upper - term.lower};
    if (hyperbolic) {
      result = {sum.lower, sum.upper + term.upper};
    } else {
      if (n % 2 == 1) result.lower = sum.lower;
      if (n % 2 == 0) result.upper = sum.upper;
    }
    if (n >= 2 && term.upper <= tiny && 2 * square <= (2 * n + 1) * (2 * n + 2)) return result;
  }
}

LevelMask read_mask(const Reader& reader, const std::vector<std::string>& variable, Budget& budget) {
  LevelMask mask{reader.integer(reader.at("first_index"), "first_index", -1000000, 1000000), {}, {}};
  std::vector<Fraction> entries;
  std::vector<Polynomial> denominators;  // the distinct ones; D is their product
  for (const Json& expression : reader.list("mask", 1, 1024)) {
    entries.push_back(read_expression(reader.text(expression, "an element of the mask"), variable, budget));
    const Polynomial& own = entries.back().denominator;
    if (std::count(denominators.begin(), denominators.end(), own) == 0) denominators.push_back(own);
  }
  Polynomial common = constant(1);
  for (const Polynomial& d : denominators) common = multiply(common, d, budget);
  mask.denominator = dense(common);
  for (auto& [numerator, own] : entries) {
    for (const Polynomial& d : denominators)
      if (d != own) numerator = multiply(numerator, d, budget);
    mask.numerators.push_back(dense(numerator));
  }
  return mask;
}

Sequence read_sequence(const Json& json, Budget& budget) {
  const Reader reader(
      json, "scheme", "the scheme",
      {"kind", "name", "parameters", "level_parameter", "type", "arity", "first_index", "mask", "first_levels"});
  reader.is_first("kind", "nonstationary", "nonstationary");
  Sequence result;
  result.name = reader.text(reader.at("name"), "name");
  const bool plain = std::all_of(result.name.begin(), result.name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           c == '.';
  });
  if (!plain || result.name.empty() || result.name.size() > 200)
    reader.fail("needs a name of letters, digits, '-', '_' and '.'");
  result.angle = reader.text(reader.list("parameters", 1, 1)[0], "the angle");
  const std::vector<std::string> variable{reader.text(reader.at("level_parameter"), "level_parameter")};
  if (!is_name(result.angle) || !is_name(variable[0]) || result.angle == variable[0])
    reader.fail("needs two different names as angle and level_parameter");
  result.hyperbolic = !reader.is_first("type", "trigonometric", "hyperbolic");
  result.arity = reader.integer(reader.at("arity"), "arity", 2, 16);
  result.mask = read_mask(reader, variable, budget);
  for (const Json& level : reader.list("first_levels", 0, 64))
    result.first_levels.push_back(
        read_mask(Reader(level, "scheme", "a first level", {"first_index", "mask"}), variable, budget));
  return result;
}

bool sign_by_bisection(const Dense& p, const Interval& range, int depth, int& boxes, Budget& budget) {
  if (range.is_point()) return value(p, range.lower.value, budget) != 0;
  for (std::vector<mpz_class>& row : bernstein_rows({p}, range, budget)) {
    for (int sign = 0; sign < 2; ++sign) {
      if (is_positive(row, {static_cast<int>(p.size()) - 1}, {range})) return true;
      for (mpz_class& c : row) c = -c;
    }
  }
  if (depth == 60 || ++boxes > 256) return false;
  const mpq_class middle = (range.lower.value + range.upper.value) / 2;
  return sign_by_bisection(p, {range.lower, {middle, true}, ""}, depth + 1, boxes, budget) &&
         sign_by_bisection(p, {{middle, false}, range.upper, ""}, depth + 1, boxes, budget);
}

}  // namespace

Dense dense(const Polynomial& p) {
  Dense result(static_cast<std::size_t>(degree(p, 0) + 1));
  for (const auto& [exponents, c] : p) result[exponents[0]] = c;
  while (!result.empty() && result.back() == 0) result.pop_back();
  return result;
}

Polynomial sparse(const Dense& p) {
  Polynomial result;
  for (std::size_t k = 0; k < p.size(); ++k) {
    Exponents exponents{};
    exponents[0] = static_cast<std::uint16_t>(k);
    if (p[k] != 0) result[exponents] = p[k];
  }
  return result;
}

double size_of(const Dense& p) {
  double size = 1;
  for (const mpq_class& c : p) size = std::max(size, limbs(c));
  return size;
}

mpq_class value(const Dense& p, const mpq_class& x, Budget& budget) {
  const double n = static_cast<double>(p.size()), size = size_of(p);
  budget.work(n * (500 + 2 * (size + n * limbs(x)) * limbs(x)));
  mpq_class result = 0;
  for (std::size_t k = p.size(); k-- > 0;) result = result * x + p[k];
  return result;
}

Interval read_angles(const std::string& text, const Sequence& sequence, const std::string& step, Budget& budget) {
  budget.work(2000 + 2. * static_cast<double>(text.size() * text.size()));
  Interval angles = read_interval(text, step);
  if (angles.lower.value < 0 || angles.upper.value > (sequence.hyperbolic ? 100 : 3) * sequence.arity)
    throw Rejected{step, "the angles exceed the range of their type"};
  return angles;
}

SequenceCertificate read_sequence_certificate(const Json& json, Budget& budget) {
  const Reader reader(json, "format", "the certificate",
                      {"format", "version", "scheme", "claim", "verdict", "theorem", "proof"});
  SequenceCertificate result;
  result.certified = reader.is_first("verdict", "certified", "refuted");
  result.sequence = read_sequence(json["scheme"], budget);
  const Reader claim(json["claim"], "claim", "the claim", {"statement", "region"});
  result.statement = claim.text(claim.at("statement"), "statement");
  if (result.statement.size() > 1000) claim.fail("has a statement of more than 1000 bytes");
  const Reader region(claim.at("region"), "claim", "the claimed region", {result.sequence.angle});
  result.angles = read_angles(region.text(region.at(result.sequence.angle.c_str()), "the interval of the angle"),
                              result.sequence, "claim", budget);
  return result;
}

Interval level_range(const Sequence& sequence, const Interval& angles, int k, int divisor, Budget& budget) {
  mpz_class scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), static_cast<unsigned long>(sequence.arity), static_cast<unsigned long>(k + 1));
  scale *= divisor;
  const auto at = [&](const Cut& angle, bool up) {
    return bounds(on_grid(angle.value / scale, up), sequence.hyperbolic, budget);
  };
  const Bounds near = at(angles.lower, false), far = at(angles.upper, true);
  // Without open ends but at 1, which mu does not take when theta = 0 is excluded.
  const Cut one{1, sequence.hyperbolic == (angles.lower.value == 0 && angles.lower.after)};
  const bool from_zero = angles.lower.value == 0;
  if (from_zero && angles.upper.value == 0) return {{1, false}, {1, true}, ""};
  if (sequence.hyperbolic) return {from_zero ? one : Cut{near.lower, false}, {far.upper, true}, ""};
  return {{far.lower, false}, from_zero ? one : Cut{near.upper, true}, ""};
}

Interval tail_range(const Sequence& sequence, const Interval& angles, int k, Budget& budget) {
  Interval range = level_range(sequence, {{0, false}, {angles.upper.value, true}, ""}, k, 1, budget);
  if (range.is_point())  // theta = 0
    (sequence.hyperbolic ? range.upper.value : range.lower.value) +=
        (sequence.hyperbolic ? 1 : -1) * mpq_class(1, 1024);
  return range;
}

std::vector<std::vector<mpz_class>> bernstein_rows(const std::vector<Dense>& polynomials, const Interval& range,
                                                   Budget& budget) {
  std::vector<Polynomial> all;
  int most = 0;
  for (const Dense& p : polynomials) {
    all.push_back(sparse(p));
    most = std::max(most, static_cast<int>(p.size()) - 1);
  }
  budget.start_leaf();
  const Bernstein family = to_bernstein(all, {range}, {0}, {most}, budget);
  std::vector<std::vector<mpz_class>> rows;
  for (std::size_t i = 0; i < all.size(); ++i) rows.push_back(family.polynomial(i).coefficients);
  return rows;
}

bool has_strict_sign(const Dense& p, const Interval& range, Budget& budget) {
  int boxes = 0;
  return !p.empty() && sign_by_bisection(p, range, 0, boxes, budget);
}

void require_defined(const Sequence& sequence, const Interval& angles, int level, Budget& budget) {
  if (level < static_cast<int>(sequence.first_levels.size())) throw Rejected{"proof", "from_level is a first level"};
  for (int k = 0; k < level; ++k)
    if (!has_strict_sign(sequence.at_level(k).denominator, level_range(sequence, angles, k, 1, budget), budget))
      throw Rejected{"denominator", "the mask of step " + std::to_string(k) + " may have a pole"};
  if (!has_strict_sign(sequence.mask.denominator, tail_range(sequence, angles, level, budget), budget))
    throw Rejected{"denominator", "the masks from step " + std::to_string(level) + " on may have a pole"};
}

std::string shown(const Sequence& sequence) {
  return sequence.name + (sequence.hyperbolic ? " (hyperbolic)" : " (trigonometric)");
}

std::string shown_angles(const Sequence& sequence, const Interval& angles) {
  const std::string& text = angles.text;
  const std::string interval = text.size() <= 80 ? text : text.substr(0, 40) + "..." + text.substr(text.size() - 37);
  return " for " + sequence.angle + (angles.is_point() ? " = " : " in ") + interval;
}

}  // namespace limes::checker
