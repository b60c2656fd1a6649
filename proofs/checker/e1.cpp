// SPDX-License-Identifier: MIT
//
// Theorem E1: the spectral condition at an isolated extraordinary vertex or face of valence n (Reif 1995; Peters & Reif 2008): 1 is an
// eigenvalue of block 0, blocks 1 and n - 1 have a real eigenvalue lambda in (0, 1), both are simple, and all others are less than
// lambda in modulus. For one n, a number separates these; for all n, lambda grows with c = cos(2 pi j/n).
#include "proofs/checker/enclosure.hpp"
#include "proofs/checker/json.hpp"
#include "proofs/checker/vertex.hpp"

namespace limes::checker {
namespace {

[[noreturn]] void fail(const std::string& why) { throw Rejected{"spectrum", why}; }

mpq_class read_number(const Reader& reader, const Json& json, const std::string& what, Budget& budget) {
  const std::string& text = reader.text(json, what);
  if (text.size() > 400) reader.fail("has a number of more than 400 characters");
  budget.work(1000 + 2. * static_cast<double>(text.size() * text.size()));
  return read_rational(text, "proof");
}

double size_of(const std::vector<mpq_class>& p) {
  double size = 1;
  for (const mpq_class& c : p) size = std::max(size, limbs(c));
  return size;
}

/// The nanoseconds of n multiplications with addition of rationals of so many machine words.
double rational_cost(double n, double words) { return n * (500 + 0.5 * words * words); }

/// A polynomial in lambda whose coefficients f_0 .. f_d are polynomials in a second variable, c or x = 1/n.
using Family = std::vector<std::vector<mpq_class>>;

/// sum_k p_k omega^k with p_{-k} = p_k, in c = (omega + 1/omega)/2: sum_k p_k T_k(c), by T_{k+1} = 2 c T_k - T_{k-1}.
std::vector<mpq_class> in_cosine(const Laurent& p) {
  std::vector<mpq_class> result, before{1}, chebyshev{0, 1};  // T_0, T_1
  const int most = p.empty() ? 0 : p.rbegin()->first;
  const auto weight = [&](int k) { return p.contains(k) ? p.at(k) : mpq_class(0); };
  for (int k = 0; k <= most; ++k) {
    if (weight(k) != weight(-k)) throw Rejected{"symmetry", "a characteristic polynomial is not real"};
    result.resize(before.size());
    for (std::size_t i = 0; i < before.size(); ++i) result[i] += (k == 0 ? 1 : 2) * weight(k) * before[i];
    std::vector<mpq_class> next(chebyshev.size() + 1);
    for (std::size_t i = 0; i < chebyshev.size(); ++i) next[i + 1] = 2 * chebyshev[i];
    for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
    before = std::move(chebyshev), chebyshev = std::move(next);
  }
  if (!p.empty() && p.begin()->first < -most) throw Rejected{"symmetry", "a characteristic polynomial is not real"};
  return result;
}

std::vector<mpq_class> in_inverse_valence(const Laurent& p) {
  if (!p.empty() && p.begin()->first < 0) throw Rejected{"scheme", "the weights grow with the valence"};
  std::vector<mpq_class> result(p.empty() ? 0 : static_cast<std::size_t>(p.rbegin()->first) + 1);
  for (const auto& [e, c] : p) result[static_cast<std::size_t>(e)] = c;
  return result;
}

std::vector<Family> families(const RingMatrix& matrix, const std::vector<std::size_t>& image,
                             std::vector<mpq_class> (*convert)(const Laurent&), Budget& budget) {
  std::vector<Family> result;
  for (const std::vector<Laurent>& factor : characteristic_factors(matrix, image, budget)) {
    result.emplace_back();
    for (const Laurent& c : factor) result.back().push_back(convert(c));
  }
  return result;
}

/// The same without one root 1, which one of them has identically.
std::vector<Family> without_one(std::vector<Family> factors) {
  for (Family& f : factors) {
    Family quotient(f.size() - 1);
    std::vector<mpq_class> carry;
    for (std::size_t i = f.size(); i-- > 0;) {
      carry.resize(std::max(carry.size(), f[i].size()));
      for (std::size_t k = 0; k < f[i].size(); ++k) carry[k] += f[i][k];
      if (i > 0) quotient[i - 1] = carry;
    }
    if (!std::all_of(carry.begin(), carry.end(), [](const mpq_class& c) { return c == 0; })) continue;
    f = std::move(quotient);
    return factors;
  }
  fail("1 is no eigenvalue of block 0");
}

/// The values of p on [from, to], by Taylor's formula at the midpoint.
Enclosure on_cell(std::vector<mpq_class> p, const mpq_class& from, const mpq_class& to, Budget& budget) {
  const mpq_class middle = (from + to) / 2;
  const auto n = static_cast<double>(p.size());
  budget.work(1000 + rational_cost(n * n / 2 + n, size_of(p) + n * limbs(middle)));
  for (std::size_t k = 0; k < p.size(); ++k)
    for (std::size_t i = p.size() - 1; i-- > k;) p[i] += middle * p[i + 1];
  const Enclosure radius(mpq_class((to - from) / 2));
  Enclosure rest(mpq_class(0));  // |p(x) - p(middle)| at most
  for (std::size_t k = p.size(); k-- > 1;) rest = (absolute(Enclosure(p[k])) + rest) * radius;
  return (p.empty() ? Enclosure(mpq_class(0)) : Enclosure(p[0])) + hull(rest, -rest);
}

/// The values of f for lambda in [low, high], second variable in [from, to].
Enclosure on_box(Family f, const mpq_class& low, const mpq_class& high, const mpq_class& from, const mpq_class& to,
                 Budget& budget) {
  const mpq_class middle = (low + high) / 2;
  const auto n = static_cast<double>(f.size());
  double size = 0, terms = 0;
  for (const std::vector<mpq_class>& p : f) {
    size = std::max(size, size_of(p));
    terms = std::max(terms, static_cast<double>(p.size()));
  }
  budget.work(3000 * n + rational_cost(n * n / 2 * terms, size + n * limbs(middle)));
  for (std::size_t k = 0; k < f.size(); ++k) {
    for (std::size_t i = f.size() - 1; i-- > k;) {
      f[i].resize(std::max(f[i].size(), f[i + 1].size()));
      for (std::size_t e = 0; e < f[i + 1].size(); ++e) f[i][e] += middle * f[i + 1][e];
    }
  }
  const Enclosure radius(mpq_class((high - low) / 2));
  Enclosure rest(mpq_class(0));
  for (std::size_t k = f.size(); k-- > 1;) rest = (absolute(on_cell(f[k], from, to, budget)) + rest) * radius;
  return on_cell(f[0], from, to, budget) + hull(rest, -rest);
}

Family derivative_by_root(const Family& f) {
  Family result(f.begin() + 1, f.end());
  for (std::size_t i = 0; i < result.size(); ++i)
    for (mpq_class& c : result[i]) c *= static_cast<unsigned long>(i + 1);
  return result;
}

Family derivative_by_second(Family f) {
  for (std::vector<mpq_class>& p : f) {
    for (std::size_t i = 1; i < p.size(); ++i) p[i - 1] = p[i] * static_cast<unsigned long>(i);
    if (!p.empty()) p.pop_back();
  }
  return f;
}

/// The number of roots in |lambda| < radius, none on the circle, for all values in [from, to]; -1 when that is not proved.
int roots_inside(const Family& f, const mpq_class& radius, const mpq_class& from, const mpq_class& to, Budget& budget,
                 int depth = 0) {
  std::vector<Enclosure> values;
  for (const std::vector<mpq_class>& p : f) values.push_back(on_cell(p, from, to, budget));
  const int inside = roots_inside(std::move(values), radius, budget);
  if (inside >= 0 || depth == 10 || from == to) return inside;
  const mpq_class middle = (from + to) / 2;
  const int left = roots_inside(f, radius, from, middle, budget, depth + 1);
  return left >= 0 && left == roots_inside(f, radius, middle, to, budget, depth + 1) ? left : -1;
}

bool all_inside(const std::vector<Family>& factors, const mpq_class& radius, const mpq_class& from, const mpq_class& to,
                Budget& budget) {
  return std::all_of(factors.begin(), factors.end(), [&](const Family& f) {
    return roots_inside(f, radius, from, to, budget) == static_cast<int>(f.size()) - 1;
  });
}

/// The characteristic polynomials of the blocks, that of block 0 without its root 1.
struct Spectra {
  std::vector<Family> zero, first, generic;
  bool has_harmonic = false;  ///< whether blocks 1 and n - 1 are not what the others are
};

Spectra spectra(const RingScheme& scheme, int rings, std::optional<int> valence, Budget& budget) {
  const RingBlocks blocks = ring_blocks(scheme, rings, valence, budget);
  std::vector<std::size_t> image(scheme.dual ? 0 : 1);
  for (const std::size_t i : blocks.image) image.push_back(i + (scheme.dual ? 0 : 1));
  Spectra result;
  result.zero = without_one(families(blocks.zero, image, in_inverse_valence, budget));
  result.has_harmonic = blocks.first.entries != blocks.generic.entries;
  result.generic = families(blocks.generic, blocks.image, in_cosine, budget);
  result.first = result.has_harmonic ? families(blocks.first, blocks.image, in_cosine, budget) : result.generic;
  return result;
}

/// The condition for one valence: lambda is the only eigenvalue of blocks 1 and n - 1 with |lambda| >= rho, and it lies in (rho, 1);
/// beside 1, the other blocks have none.
void prove_valence(const Spectra& spectra, int n, const mpq_class& rho, Budget& budget) {
  if (rho <= 0 || rho >= 1) fail("the separator does not lie between 0 and 1");
  if (!all_inside(spectra.zero, rho, 0, 0, budget)) fail("block 0 has another eigenvalue than 1 above the separator");
  for (int j = 1; j <= n / 2; ++j) {
    const mpq_class turn(j, n);
    budget.work(50 * enclosure_cost);
    const Enclosure c = cosine(turn);
    if (j > 1) {
      if (!all_inside(spectra.generic, rho, c.least(), c.greatest(), budget))
        fail("block " + std::to_string(j) + " has an eigenvalue above the separator");
      continue;
    }
    int outside = 0;
    Enclosure at_separator(mpq_class(1)), at_one(mpq_class(1));
    for (const Family& f : spectra.first) {
      const int inside = roots_inside(f, rho, c.least(), c.greatest(), budget);
      if (inside < 0) fail("an eigenvalue of block 1 is too close to the separator");
      outside += static_cast<int>(f.size()) - 1 - inside;
      at_separator = at_separator * on_box(f, rho, rho, c.least(), c.greatest(), budget);
      at_one = at_one * on_box(f, 1, 1, c.least(), c.greatest(), budget);
    }
    if (outside != 1) fail("block 1 has not one eigenvalue above the separator, but " + std::to_string(outside));
    // With one root of modulus above rho, which is real, the product is negative between rho and this root alone.
    if (!at_separator.is_negative() || !at_one.is_positive())
      fail("the subdominant eigenvalue is not between the separator and 1");
  }
}

/// A cell of c on which lambda(c), in (low, high), is the only eigenvalue of a block with modulus >= separator.
struct Cell {
  mpq_class from, to, separator, low, high;
};

/// The condition for all n >= from. Let lambda(c) be the subdominant eigenvalue of block 1 as a function of c = cos(2 pi/n).
class AllValences {
 public:
  AllValences(const Spectra& spectra, const Json& json, Budget& budget) : spectra_(spectra), budget_(budget) {
    std::vector<std::string> keys{"from", "start", "bound", "cells"};
    const bool touches = json.is_object() && json.contains("touch");
    if (touches) keys.emplace_back("touch");
    const Reader reader(json, "proof", "the proof for all valences", keys);
    from_ = reader.integer(reader.at("from"), "from", 3, max_valence);
    bound_ = read_number(reader, reader.at("bound"), "bound", budget);
    if (touches) touch_ = read_number(reader, reader.at("touch"), "touch", budget);
    mpq_class from = start_ = read_number(reader, reader.at("start"), "start", budget);
    for (const Json& json_cell : reader.list("cells", 1, 1000)) {
      const Reader own(json_cell, "proof", "a cell", {"to", "separator", "root"});
      const Json& root = own.list("root", 2, 2);
      const auto number = [&](const Json& text, const char* what) { return read_number(own, text, what, budget); };
      cells_.push_back({from, number(own.at("to"), "to"), number(own.at("separator"), "separator"),
                        number(root[0], "an end of root"), number(root[1], "an end of root")});
      from = cells_.back().to;
    }
  }

  int from() const { return from_; }
  const std::vector<Cell>& cells() const { return cells_; }

  void prove() {
    least_cosine_ = cosine(mpq_class(1, from_)).least();
    if (start_ < -1 || start_ > least_cosine_ || cells_.back().to != 1 || bound_ <= 0)
      fail("the cells do not cover the cosines of all valences");
    for (const Cell& cell : cells_) prove_cell(cell);
    // What is left of the other blocks: with a harmonic all of c_j, else c_j <= start.
    if (!all_inside(spectra_.generic, bound_, -1, spectra_.has_harmonic ? mpq_class(1) : start_, budget_))
      fail("a block other than 0 and 1 may have an eigenvalue above the bound");
    const mpq_class x(1, from_);
    if (!touch_) {
      if (!all_inside(spectra_.zero, bound_, 0, x, budget_))
        fail("block 0 may have another eigenvalue than 1 above the bound");
    } else {
      prove_touch(x);
    }
  }

 private:
  void prove_cell(const Cell& cell) {
    const auto& [from, to, separator, low, high] = cell;
    if (!(from < to && 0 < separator && separator < low && low < high && high < 1)) fail("a cell is not in order");
    if (to > least_cosine_ && low < bound_) fail("the bound is not below all subdominant eigenvalues");
    const Family* leading = nullptr;
    for (const Family& f : spectra_.first) {
      const int inside = roots_inside(f, separator, from, to, budget_), degree = static_cast<int>(f.size()) - 1;
      if (inside < degree - 1 || (inside == degree - 1 && leading))
        fail("block 1 may have more than one eigenvalue above the separator of a cell");
      if (inside == degree - 1) leading = &f;
    }
    if (!leading || (leading_ && leading_ != leading)) fail("no eigenvalue of block 1 is above the separator of a cell");
    leading_ = leading;
    if (!on_box(*leading, low, low, from, to, budget_).is_negative() ||
        !on_box(*leading, high, high, from, to, budget_).is_positive())
      fail("the subdominant eigenvalue may leave the root's interval of a cell");
    if (spectra_.has_harmonic) return;
    // d lambda / d c = -f_c / f_lambda > 0.
    if (!on_box(derivative_by_root(*leading), low, high, from, to, budget_).is_positive() ||
        !on_box(derivative_by_second(*leading), low, high, from, to, budget_).is_negative())
      fail("the subdominant eigenvalue is not proved to grow with the cosine");
  }

  /// Block 0 depends on x = 1/n, and one of its eigenvalues tends to lambda(1) with n: f(lambda, 1) is its factor g(lambda, x) at x = 0. With
  /// F(x) = g(lambda(cos 2 pi x), x): F(0) = 0, and F' > 0 on [0, 1/from] shows that the only root of g above `touch` is less than lambda.
  void prove_touch(const mpq_class& x) {
    const mpq_class& touch = *touch_;
    const Family* zero = nullptr;
    for (const Family& f : spectra_.zero) {
      const int inside = roots_inside(f, touch, 0, x, budget_), degree = static_cast<int>(f.size()) - 1;
      if (inside < degree - 1 || (inside == degree - 1 && zero))
        fail("block 0 may have more than two eigenvalues above the touching separator");
      if (inside == degree - 1) zero = &f;
    }
    if (!zero) fail("no eigenvalue of block 0 but 1 is above the touching separator");
    if (touch <= 0 || !on_box(*zero, touch, touch, 0, x, budget_).is_negative())
      fail("the second eigenvalue of block 0 may be less than the touching separator");
    if (zero->size() != leading_->size()) fail("blocks 0 and 1 do not touch");
    for (std::size_t i = 0; i < zero->size(); ++i) {
      mpq_class at_one = 0;
      for (const mpq_class& c : (*leading_)[i]) at_one += c;
      if (at_one != ((*zero)[i].empty() ? mpq_class(0) : (*zero)[i][0])) fail("blocks 0 and 1 do not touch");
    }
    for (const auto& [from, to, separator, low, high] : cells_) {
      if (low <= touch) fail("the touching separator is not below all roots");
      const auto on_this = [&](const Family& f) { return on_box(f, low, high, from, to, budget_); };
      const Enclosure by_own_root = on_this(derivative_by_root(*leading_));
      if (!by_own_root.is_positive()) fail("the subdominant eigenvalue is not proved to be differentiable");
      const Enclosure slope = absolute(on_this(derivative_by_second(*leading_))) / by_own_root;
      const Enclosure by_root = on_box(derivative_by_root(*zero), low, high, 0, x, budget_);
      const Enclosure by_x = on_box(derivative_by_second(*zero), low, high, 0, x, budget_);
      // F' = g_x + g_lambda lambda'(c) c'(x), and c'(x)^2 = 4 pi^2 (1 - c^2).
      const mpq_class least_square = from < 0 && to > 0 ? mpq_class(0) : std::min(mpq_class(from * from), mpq_class(to * to));
      const Enclosure drift = Enclosure(2) * pi() * absolute(by_root) * slope;
      if (!by_x.is_positive() || !(drift * drift * Enclosure(1 - least_square) < by_x * by_x))
        fail("the second eigenvalue of block 0 is not proved to be less than the subdominant one");
    }
  }

  const Spectra& spectra_;
  Budget& budget_;
  int from_ = 3;
  mpq_class start_, bound_, least_cosine_;
  std::optional<mpq_class> touch_;
  std::vector<Cell> cells_;
  const Family* leading_ = nullptr;
};

}  // namespace

std::vector<Separation> prove_spectral_condition(const RingScheme& scheme, int rings, const Valences& valences,
                                                 const Json& one_by_one, const Json* all, Budget& budget) {
  std::vector<Separation> result;
  int next = valences.first;
  for (const Json& entry : one_by_one) {
    const Reader own(entry, "proof", "a valence of the proof", {"valence", "separator"});
    const int n = own.integer(own.at("valence"), "valence", 3, max_valence);
    if (n != next++) own.fail("is not the next one");
    const mpq_class separator = read_number(own, own.at("separator"), "separator", budget);
    try {
      prove_valence(spectra(scheme, rings, n, budget), n, separator, budget);
    } catch (const Rejected& rejected) {
      throw Rejected{rejected.step, "valence " + std::to_string(n) + ": " + rejected.reason};
    }
    result.push_back({n, 0, 0, separator});
  }
  if (valences.last ? next != *valences.last + 1 : !all)
    throw Rejected{"proof", "the proof is not about the claimed valences"};
  if (all) {
    const Spectra together = spectra(scheme, rings, std::nullopt, budget);
    AllValences proof(together, *all, budget);
    if (proof.from() != next) throw Rejected{"proof", "the proof is not about the claimed valences"};
    proof.prove();
    for (const Cell& cell : proof.cells()) result.push_back({0, cell.from, cell.to, cell.separator});
  }
  return result;
}

}  // namespace limes::checker
