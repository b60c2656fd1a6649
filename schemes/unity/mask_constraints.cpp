#include "algebra/error.hpp"
#include "algebra/number/read_rational.hpp"
#include "schemes/unity/derive_mask.hpp"

#include <fmt/format.h>

namespace limes {
namespace {

/// Equations sum_k row[k] c_k = row[count], in reduced echelon form: each new one is cleared of the old ones' pivots and they of its.
class Equations {
 public:
  explicit Equations(int count) : count_(count) {}

  /// \throws InputError when the equation contradicts the earlier ones
  void add(std::vector<Rational> row, const std::string& origin) {
    for (std::size_t r = 0; r < rows_.size(); ++r) subtract(row, rows_[r], pivots_[r]);
    // The greatest entry keeps the others' multiples small when the free coefficients are rounded.
    int pivot = -1;
    for (int k = 0; k < count_; ++k) {
      if (row[k] != 0 && (pivot < 0 || abs(row[k]) > abs(row[pivot]))) pivot = k;
    }
    if (pivot < 0) {
      if (row[count_] == 0) return;
      throw InputError(fmt::format("infeasible constraints: {} contradicts the others for {} coefficients", origin, count_));
    }
    const Rational scale = row[pivot];
    for (Rational& x : row) x /= scale;
    for (auto& earlier : rows_) subtract(earlier, row, pivot);
    rows_.push_back(std::move(row));
    pivots_.push_back(pivot);
  }

  AffineSolutions solutions() const {
    AffineSolutions result{.particular = std::vector<Rational>(count_), .basis = {}, .free = {}};
    for (int k = 0; k < count_; ++k) {
      if (std::find(pivots_.begin(), pivots_.end(), k) == pivots_.end()) result.free.push_back(k);
    }
    result.basis = RationalMatrix(count_, static_cast<int>(result.free.size()));
    for (int j = 0; j < result.basis.columns(); ++j) {
      result.basis(result.free[j], j) = 1;
      for (std::size_t r = 0; r < rows_.size(); ++r) result.basis(pivots_[r], j) = -rows_[r][result.free[j]];
    }
    for (std::size_t r = 0; r < rows_.size(); ++r) result.particular[pivots_[r]] = rows_[r][count_];
    return result;
  }

 private:
  void subtract(std::vector<Rational>& from, const std::vector<Rational>& row, int pivot) const {
    const Rational factor = from[pivot];
    if (factor == 0) return;
    for (int k = 0; k <= count_; ++k) from[k] -= factor * row[k];
  }

  int count_;
  std::vector<std::vector<Rational>> rows_;
  std::vector<int> pivots_;
};

}  // namespace

void read_constraint(const std::string& text, MaskConstraints& constraints) {
  if (text == "interpolation") {
    constraints.interpolation = true;
  } else if (text == "symmetry") {
    constraints.symmetry = true;
  } else if (text.starts_with("sum-rules=")) {
    const Rational order = read_rational(std::string_view(text).substr(10));
    if (denominator(order) != 1 || order < 1 || order > 64) throw InputError(fmt::format("constraint '{}': the order is an integer from 1 to 64", text));
    constraints.sum_rules = static_cast<int>(numerator(order));
  } else {
    throw InputError(fmt::format("unknown constraint '{}' (known: sum-rules=K, interpolation, symmetry)", text));
  }
}

AffineSolutions solve_constraints(const MaskConstraints& constraints, const RefinementEquation& equation) {
  const int n = equation.count;
  Equations equations(n);
  if (constraints.interpolation) {
    const Rational zero = -equation.first_shift;
    if (denominator(zero) != 1 || zero < 0 || zero >= n) throw InputError("interpolation needs the shift 0 among the shifts");
    const int centre = static_cast<int>(numerator(zero));
    for (int k = centre % 2; k < n; k += 2) {
      if (k == centre) continue;
      std::vector<Rational> row(n + 1);
      row[k] = 1;
      equations.add(std::move(row), "interpolation");
    }
  }
  for (int k = 0; constraints.symmetry && k < n / 2; ++k) {
    std::vector<Rational> row(n + 1);
    row[k] = 1;
    row[n - 1 - k] = -1;
    equations.add(std::move(row), "symmetry");
  }
  if (constraints.sum_rules > 0) {
    std::vector<Rational> ones(n + 1, Rational(1));
    ones[n] = 2;
    equations.add(std::move(ones), "the sum 2");
  }
  for (int j = 0; j < constraints.sum_rules; ++j) {
    std::vector<Rational> row(n + 1);
    // Powers of the distance to the middle: smaller numbers than the powers of k, and the same equations together.
    for (int k = 0; k < n; ++k) row[k] = (k % 2 ? -1 : 1) * power(Rational(2 * k - n + 1) / 2, j);
    equations.add(std::move(row), fmt::format("the sum rule of order {}", j + 1));
  }
  return equations.solutions();
}

}  // namespace limes
