// SPDX-License-Identifier: MIT
//
// The regular part of a surface scheme, where the limit is a tensor product: smooth, determined by the rings, and no ring without
// influence on it.
#include "proofs/checker/certificate.hpp"
#include "proofs/checker/ring.hpp"

namespace limes::checker {
namespace {

using Row = std::vector<mpq_class>;

/// A space of rows, by a basis in echelon form.
class RowSpace {
 public:
  RowSpace(std::size_t size, Budget& budget) : size_(size), budget_(budget) {}

  /// \returns whether the row was not in the space before
  bool include(Row row) {
    budget_.work(1e4 * static_cast<double>(size_));
    for (std::size_t k = 0; k < size_; ++k) {
      if (row[k] == 0) continue;
      const auto own = basis_.find(k);
      if (own == basis_.end()) {
        const mpq_class scale = 1 / row[k];
        for (mpq_class& x : row) x *= scale;
        return basis_.emplace(k, std::move(row)).second;
      }
      const mpq_class factor = row[k];
      double words = limbs(factor);
      for (std::size_t j = k; j < size_; ++j) words = std::max(words, limbs(row[j]) + limbs(own->second[j]));
      budget_.work(static_cast<double>(size_) * (500 + words * words));
      for (std::size_t j = k; j < size_; ++j) row[j] -= factor * own->second[j];
    }
    return false;
  }
  bool is_everything() const { return basis_.size() == size_; }
  /// x with row x = 0 for all rows. \pre all but one dimension are there
  Row kernel() const {
    Row x(size_);
    for (std::size_t k = size_; k-- > 0;) {
      const auto own = basis_.find(k);
      if (own == basis_.end()) x[k] = 1;
      for (std::size_t j = k + 1; own != basis_.end() && j < size_; ++j) x[k] -= own->second[j] * x[j];
    }
    return x;
  }
  std::size_t dimension() const { return basis_.size(); }

 private:
  std::size_t size_;
  Budget& budget_;
  std::map<std::size_t, Row> basis_;  // by the place of the first entry, which is 1
};

/// Whether the functions phi(x - k) that do not vanish on [0, 1], phi the limit function of the mask, are linearly independent there. On [0, 1]
/// the data d_k, 1 - last <= k <= -first, count. With (A_e)_{ik} = a_{i+e-2k} the values at dyadic points are u A_{e_m} .. A_{e_1} d, where
/// u A_0 = u gives the value at 0: these rows have to span everything. \pre the curve scheme converges, so u is unique up to a factor
bool is_locally_independent(const std::vector<mpq_class>& mask, int first, Budget& budget) {
  const int last = first + static_cast<int>(mask.size()) - 1;
  const std::size_t size = mask.size() - 1;
  const auto entry = [&](int e, std::size_t i, std::size_t k) {
    const int j = static_cast<int>(i) - 2 * static_cast<int>(k) + e + last - 1 - first;
    return j < 0 || j > last - first ? mpq_class(0) : mask[static_cast<std::size_t>(j)];
  };
  RowSpace equations(size, budget);
  for (std::size_t k = 0; k < size; ++k) {
    Row column(size);
    for (std::size_t i = 0; i < size; ++i) column[i] = entry(0, i, k) - (i == k ? 1 : 0);
    equations.include(std::move(column));
  }
  if (equations.dimension() + 1 != size) return false;
  RowSpace values(size, budget);
  std::vector<Row> open{equations.kernel()};
  values.include(open.front());
  while (!open.empty()) {
    const Row row = std::move(open.back());
    open.pop_back();
    for (int e = 0; e < 2; ++e) {
      Row next(size);
      double words = 0, longest = 0;
      for (const mpq_class& x : row) words = std::max(words, limbs(x));
      for (const mpq_class& x : mask) longest = std::max(longest, limbs(x));
      budget.work(static_cast<double>(size * size) * (1000 + 4 * (words + longest) * longest));
      for (std::size_t k = 0; k < size; ++k)
        for (std::size_t i = 0; i < size; ++i) next[k] += row[i] * entry(e, i, k);
      if (values.include(next)) open.push_back(std::move(next));
    }
  }
  return values.is_everything();
}

}  // namespace

void prove_regular_part(const RingScheme& scheme, int rings, int level, Budget& budget) {
  Scheme curve{scheme.name, {}, 2, {}, constant(1)};
  std::vector<mpq_class> mask;
  for (const Fraction& a : scheme.mask) {
    mask.emplace_back(a.numerator.empty() ? mpq_class(0)
                                          : mpq_class(a.numerator.begin()->second / a.denominator.begin()->second));
    curve.mask.push_back(mask.back() == 0 ? Polynomial{} : constant(mask.back()));
  }
  if (mask.front() == 0) throw Rejected{"scheme", "the mask ends with zeros"};
  const LocalScheme local = restrict_to_leaf(curve, 1, {}, budget);
  budget.work(norm_work(local, level));
  prove_symbol(local);
  prove_norm(local, level);

  // A control point k takes part in the limit on (k + first, k + last); those of further rings begin at rings + 1 - last.
  if (rings < scheme.last) throw Rejected{"rings", "the rings do not determine the limit near the vertex or face"};
  // Patches are regular from X on, when new points of the columns from 2 X - last + 1 on have no rules of their own and X - last + 1 >= 0;
  // their control points begin with the column X - last + 1, so this has to be the first one beside the vertex (face).
  const int column = std::max(0, (scheme.given_reach() + scheme.last + 1) / 2 - scheme.last + 1);
  if (column > (scheme.dual ? 0 : 1) || !is_locally_independent(mask, scheme.first(), budget))
    throw Rejected{"effective", "control points near the vertex or face may have no influence on regular patches"};
}

}  // namespace limes::checker
