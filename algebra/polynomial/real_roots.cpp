// Sturm's theorem with a chain of primitive integer polynomials: each remainder is a pseudo-remainder divided by its
// content, so that only signs, which is all that the theorem uses, are those of the classical chain. [Basu, Pollack &
// Roy 2006, chapter 2]
#include "algebra/polynomial/real_roots.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/polynomial_impl.hpp"

#include <flint/fmpz_poly.h>

#include <algorithm>
#include <memory>

namespace limes {

namespace {

// An integer polynomial divided by its (positive) content.
class PrimitivePolynomial {
 public:
  PrimitivePolynomial() { fmpz_poly_init(value); }
  explicit PrimitivePolynomial(const Polynomial& a) : PrimitivePolynomial() {
    fmpq_poly_get_numerator(value, a.impl().poly);
    divide_content();
  }
  PrimitivePolynomial(const PrimitivePolynomial&) = delete;
  PrimitivePolynomial& operator=(const PrimitivePolynomial&) = delete;
  ~PrimitivePolynomial() { fmpz_poly_clear(value); }

  void divide_content() {
    if (fmpz_poly_is_zero(value)) return;
    FlintInteger content;
    fmpz_poly_content(content.data, value);
    fmpz_poly_scalar_divexact_fmpz(value, value, content.data);
  }

  int degree() const { return int(fmpz_poly_degree(value)); }
  // The sign for x -> infinity (direction +1) or -infinity (-1).
  int sign_at_infinity(int direction) const {
    const int leading = fmpz_sgn(fmpz_poly_lead(value));
    return direction < 0 && degree() % 2 != 0 ? -leading : leading;
  }
  int sign_at(const Rational& x) const {
    const FlintRational point(x);
    FlintRational result;
    fmpz_poly_evaluate_fmpq(result.data, value, point.data);
    return fmpq_sgn(result.data);
  }

  fmpz_poly_t value;
};

// Counts changes of sign in a sequence, zeros skipped.
class Variations {
 public:
  void add(int sign) {
    if (sign == 0) return;
    if (sign == -last_) ++count_;
    last_ = sign;
  }
  int count() const { return count_; }

 private:
  int last_ = 0;
  int count_ = 0;
};

class SturmChain {
 public:
  explicit SturmChain(const Polynomial& square_free) {
    chain_.push_back(std::make_unique<PrimitivePolynomial>(square_free));
    if (square_free.degree() < 1) return;
    chain_.push_back(std::make_unique<PrimitivePolynomial>());
    fmpz_poly_derivative(chain_[1]->value, chain_[0]->value);
    chain_[1]->divide_content();
    while (chain_.back()->degree() > 0) {
      const auto& a = chain_[chain_.size() - 2]->value;
      const auto& b = chain_.back()->value;
      auto next = std::make_unique<PrimitivePolynomial>();
      ulong d = 0;
      fmpz_poly_pseudo_rem(next->value, &d, a, b);
      // lead(b)^d a = q b + next: the chain continues with -next over the sign of lead(b)^d.
      if (fmpz_sgn(fmpz_poly_lead(b)) > 0 || d % 2 == 0) fmpz_poly_neg(next->value, next->value);
      if (fmpz_poly_is_zero(next->value)) throw InternalError("a Sturm chain of a polynomial that is not square-free");
      next->divide_content();
      chain_.push_back(std::move(next));
    }
  }

  /// Sign changes along the chain at x; between two points they drop by the number of roots in (lower, upper].
  int variations_at(const Rational& x) const {
    Variations result;
    for (const auto& p : chain_) result.add(p->sign_at(x));
    return result.count();
  }
  int variations_at_infinity(int direction) const {
    Variations result;
    for (const auto& p : chain_) result.add(p->sign_at_infinity(direction));
    return result.count();
  }
  int sign_at(const Rational& x) const { return chain_[0]->sign_at(x); }
  /// The sign on a small interval to the right of x.
  int sign_right_of(const Rational& x) const {
    const int sign = sign_at(x);
    return sign != 0 || chain_.size() < 2 ? sign : chain_[1]->sign_at(x);
  }

 private:
  std::vector<std::unique_ptr<PrimitivePolynomial>> chain_;
};

Polynomial checked_square_free_part(const Polynomial& a) {
  if (a.is_zero()) throw DomainError("the roots of the zero polynomial were asked for");
  return square_free_part(a);
}

// A power of two above the modulus of every root (Cauchy's bound).
Rational root_bound(const Polynomial& a) {
  Rational greatest = 0;
  for (int i = 0; i < a.degree(); ++i) greatest = std::max<Rational>(greatest, abs(a.coefficient(i)));
  const Rational bound = 1 + greatest / abs(a.leading_coefficient());
  Rational power = 1;
  while (power <= bound) power *= 2;
  return power;
}

// The open interval (lower, upper), with the variations of the chain at its ends.
struct Piece {
  Rational lower;
  Rational upper;
  int lower_variations;
  int upper_variations;
  bool upper_is_root;
};

// Open intervals with exactly one root each, and points, ascending.
std::vector<RootInterval> separate_roots(const SturmChain& chain, const Rational& bound) {
  std::vector<RootInterval> result;
  // The leftmost piece is on top. A root hit by a cut waits there as a piece of width 0.
  std::vector<Piece> pieces{{-bound, bound, chain.variations_at(-bound), chain.variations_at(bound), false}};
  while (!pieces.empty()) {
    const Piece piece = pieces.back();
    pieces.pop_back();
    if (piece.lower == piece.upper) {
      result.push_back({piece.lower, piece.lower});
      continue;
    }
    const int count = piece.lower_variations - piece.upper_variations - (piece.upper_is_root ? 1 : 0);
    if (count == 1) result.push_back({piece.lower, piece.upper});
    if (count < 2) continue;
    const Rational middle = (piece.lower + piece.upper) / 2;
    const int variations = chain.variations_at(middle);
    const bool root = chain.sign_at(middle) == 0;
    pieces.push_back({middle, piece.upper, variations, piece.upper_variations, piece.upper_is_root});
    if (root) pieces.push_back({middle, middle, variations, variations, true});
    pieces.push_back({piece.lower, middle, piece.lower_variations, variations, root});
  }
  return result;
}

// Halves an open interval with exactly one root; it becomes a point when the midpoint is that root.
void halve(RootInterval& interval, const SturmChain& chain) {
  const Rational middle = (interval.lower + interval.upper) / 2;
  const int sign = chain.sign_at(middle);
  if (sign == 0) {
    interval.lower = interval.upper = middle;
  } else if (sign == chain.sign_right_of(interval.lower)) {
    interval.lower = middle;
  } else {
    interval.upper = middle;
  }
}

}  // namespace

int count_real_roots(const Polynomial& a, const Rational& lower, const Rational& upper) {
  if (lower > upper) throw DomainError("roots were counted in an interval with lower > upper");
  const SturmChain chain(checked_square_free_part(a));
  return chain.variations_at(lower) - chain.variations_at(upper);
}

int count_real_roots(const Polynomial& a) {
  const SturmChain chain(checked_square_free_part(a));
  return chain.variations_at_infinity(-1) - chain.variations_at_infinity(1);
}

std::vector<RootInterval> isolate_real_roots(const Polynomial& a, const Rational& width) {
  if (width <= 0) throw DomainError("roots were isolated to a width that is not positive");
  const Polynomial square_free = checked_square_free_part(a);
  const SturmChain chain(square_free);
  std::vector<RootInterval> result = separate_roots(chain, root_bound(square_free));

  const auto is_point = [](const RootInterval& interval) { return interval.lower == interval.upper; };
  for (auto& interval : result) {
    // Another root may sit on an excluded end; the closed interval must not contain it.
    while (!is_point(interval) && (interval.upper - interval.lower > width || chain.sign_at(interval.lower) == 0 ||
                                   chain.sign_at(interval.upper) == 0))
      halve(interval, chain);
    if (is_point(interval)) continue;
    const Rational candidate = simplest_between(interval.lower, interval.upper);
    if (chain.sign_at(candidate) == 0) interval.lower = interval.upper = candidate;
  }
  for (std::size_t i = 1; i < result.size(); ++i) {
    while (result[i - 1].upper >= result[i].lower) {
      // Two points are distinct, so one of the two can be halved.
      halve(is_point(result[i]) ? result[i - 1] : result[i], chain);
    }
  }

  // No end of an interval is a root, so a factor has its simple root there exactly when its sign changes.
  for (const auto& [factor, multiplicity] : square_free_factorisation(a)) {
    const PrimitivePolynomial p(factor);
    for (auto& interval : result) {
      if (p.sign_at(interval.lower) * p.sign_at(interval.upper) <= 0) interval.multiplicity = multiplicity;
    }
  }
  return result;
}

}  // namespace limes
