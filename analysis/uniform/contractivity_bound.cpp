#include "analysis/uniform/contractivity_bound.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/bernstein_form.hpp"
#include "analysis/uniform/iterated_symbol.hpp"

#include <fmt/format.h>

#include <cmath>

namespace limes {
namespace {

/// The least common denominator of all entries.
Integer common_denominator(const std::vector<std::vector<Rational>>& rows) {
  Integer result = 1;
  for (const auto& row : rows) {
    for (const Rational& x : row) result = lcm(result, denominator(x));
  }
  return result;
}

/// The row times `scale`, a multiple of its denominators.
std::vector<Integer> scaled(const std::vector<Rational>& row, const Integer& scale) {
  std::vector<Integer> result;
  for (const Rational& x : row) result.push_back(numerator(x) * (scale / denominator(x)));
  return result;
}

void refine_to(IteratedSymbol& symbol, int level, double max_bytes, const Stop& stop) {
  if (symbol.bytes_at(level) > max_bytes) {
    throw LimitError(fmt::format("level {} of the difference scheme needs more than {:.0f} MB", level, max_bytes / 1e6));
  }
  while (symbol.level() < level) symbol.refine(stop);
}

/// Bernstein coefficients times binomials: the homogeneous coefficients of IteratedSymbol.
std::vector<Rational> homogeneous(const BernsteinForm& form) {
  std::vector<Rational> result = form.coefficients();
  const std::vector<int>& degrees = form.degrees();
  std::size_t inner = 1;
  for (std::size_t axis = degrees.size(); axis-- > 0;) {
    Rational binomial = 1;
    std::vector<Rational> binomials;
    for (int i = 0; i <= degrees[axis]; ++i) {
      binomials.push_back(binomial);
      binomial *= Rational(degrees[axis] - i) / (i + 1);
    }
    for (std::size_t k = 0; k < result.size(); ++k) result[k] *= binomials[(k / inner) % binomials.size()];
    inner *= binomials.size();
  }
  return result;
}

}  // namespace

Rational exact_contractivity_norm(const LaurentPolynomial& b, int arity, int level, const Stop& stop, double max_bytes) {
  if (level < 1) throw DomainError("exact_contractivity_norm: the level must be at least 1");
  if (b.is_zero()) return 0;
  const std::vector<std::vector<Rational>> rows{b.rational_coefficients()};
  const Integer scale = common_denominator(rows);
  std::vector<std::vector<Integer>> coefficients;
  for (const Integer& c : scaled(rows[0], scale)) coefficients.push_back({c});
  IteratedSymbol symbol(arity, {}, coefficients);
  refine_to(symbol, level, max_bytes, stop);
  Integer greatest = 0;
  symbol.visit_row_sums([&](const std::vector<Integer>& row) {
    if (row[0] > greatest) greatest = row[0];
    return true;
  });
  return Rational(greatest) / Rational(pow(scale, static_cast<unsigned>(level)));
}

std::vector<double> approx_contractivity_norms(const LaurentPolynomial& b, int arity, std::span<const Rational> point,
                                               int max_level, double enough) {
  constexpr std::size_t max_length = std::size_t(1) << 23;
  std::vector<double> symbol;
  for (const RationalFunction& c : b.coefficients()) symbol.push_back(approx_double(c(point)));
  std::vector<double> iterated = symbol;
  std::vector<double> norms;
  std::size_t stride = arity;
  for (int level = 1;; ++level, stride *= arity) {
    std::vector<double> rows(std::min(stride, iterated.size()), 0);
    for (std::size_t i = 0; i < iterated.size(); ++i) rows[i % stride] += std::abs(iterated[i]);
    norms.push_back(rows.empty() ? 0 : *std::max_element(rows.begin(), rows.end()));
    const std::size_t length = (iterated.size() - 1) * arity + symbol.size();
    if (norms.back() < enough || level == max_level || length > max_length) return norms;
    std::vector<double> next(length, 0);
    for (std::size_t j = 0; j < iterated.size(); ++j) {
      for (std::size_t i = 0; i < symbol.size(); ++i) next[j * arity + i] += symbol[i] * iterated[j];
    }
    iterated = std::move(next);
  }
}

ContractivityBound::ContractivityBound(const LaurentPolynomial& b, const MultivariatePolynomial& denominator, int arity,
                                       const Box& box)
    : arity_(arity) {
  const int variables = b.variables();
  // B = D b, then D itself; parameters at points are substituted by BernsteinForm.
  std::vector<MultivariatePolynomial> polynomials = numerators_over(b, denominator);
  polynomials.push_back(denominator);

  std::vector<int> degrees(variables, 0);
  for (const MultivariatePolynomial& p : polynomials) {
    const std::vector<int> own = p.degrees();
    for (int k = 0; k < variables; ++k) degrees[k] = std::max(degrees[k], own[k]);
  }
  for (int k = 0; k < variables; ++k) {
    if (box[k].is_point()) {
      degrees[k] = 0;
      continue;
    }
    degrees_.push_back(degrees[k]);
    lower_open_.push_back(box[k].lower_open);
    upper_open_.push_back(box[k].upper_open);
  }
  const int sign = BernsteinForm(denominator, box, degrees).strict_sign_off_open_faces();
  denominator_is_signed_ = sign != 0;
  if (!denominator_is_signed_) return;
  std::vector<std::vector<Rational>> rows;
  for (MultivariatePolynomial& p : polynomials) {
    if (sign < 0) p = -p;
    rows.push_back(homogeneous(BernsteinForm(p, box, degrees)));
  }
  const Integer scale = common_denominator(rows);
  for (const auto& row : rows) numerators_.push_back(scaled(row, scale));
  denominator_ = std::move(numerators_.back());
  numerators_.pop_back();
}

bool ContractivityBound::proves_contraction(int level, const ContractivityLimits& limits, const Stop& stop) const {
  if (!denominator_is_signed_) return false;
  if (numerators_.empty()) return true;  // b = 0

  IteratedSymbol symbol(arity_, degrees_, numerators_);
  refine_to(symbol, level, limits.max_bytes, stop);
  IteratedSymbol denominator(arity_, degrees_, {denominator_});
  refine_to(denominator, level, limits.max_bytes, stop);
  // D has a single coefficient in z, so its level l is D^l; its coefficients are non-negative, so the row sum is D^l itself.
  std::vector<Integer> bound;
  denominator.visit_row_sums([&](const std::vector<Integer>& row) {
    bound = row;
    return false;
  });

  const std::size_t axes = degrees_.size();
  std::vector<int> width(axes);
  for (std::size_t k = 0; k < axes; ++k) width[k] = level * degrees_[k] + 1;
  const auto index_of = [&](std::size_t place, std::vector<int>& index) {
    for (std::size_t k = axes; k-- > 0;) {
      index[k] = static_cast<int>(place % width[k]);
      place /= width[k];
    }
  };
  bool proved = true;
  std::vector<int> index(axes);
  symbol.visit_row_sums([&](const std::vector<Integer>& row) {
    // The smallest box of multi-indices that holds all non-zero differences; it may leave out strips at open ends only, and
    // inside of it every difference must be positive.
    std::vector<int> low(axes, 1 << 30);
    std::vector<int> high(axes, -1);
    for (std::size_t place = 0; place < row.size(); ++place) {
      const int order = bound[place].compare(row[place]);
      if (order < 0) return proved = false;
      if (order == 0) continue;
      index_of(place, index);
      for (std::size_t k = 0; k < axes; ++k) {
        low[k] = std::min(low[k], index[k]);
        high[k] = std::max(high[k], index[k]);
      }
    }
    std::size_t expected = 1;
    for (std::size_t k = 0; k < axes; ++k) {
      if (high[k] < 0 || (low[k] > 0 && !lower_open_[k]) || (high[k] < width[k] - 1 && !upper_open_[k])) return proved = false;
      expected *= high[k] - low[k] + 1;
    }
    std::size_t positive = 0;
    for (std::size_t place = 0; place < row.size(); ++place) positive += bound[place] > row[place];
    return proved = positive == expected;
  });
  return proved;
}

}  // namespace limes
