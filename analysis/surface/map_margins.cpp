#include "algebra/error.hpp"
#include "analysis/surface/map_number_impl.hpp"

#include <numbers>

namespace limes {

using namespace approx_map;

/// Values with indices from a and b on.
struct ApproxCharacteristicMap::Field {
  int first_a = 0, first_b = 0;
  std::vector<std::vector<Ends>> rows;  // by a
};

namespace {

/// New data from old ones in one direction, from `first` to `last`; the mask's first index is `lowest`.
std::vector<Ends> refined(const std::vector<Ends>& old, int old_first, const std::vector<double>& mask, int lowest, int first, int last) {
  std::vector<Ends> result;
  for (int i = first; i <= last; ++i) {
    Ends sum{0, 0};
    for (int k = (i - lowest) & 1; k < int(mask.size()); k += 2) {
      const double w = mask[std::size_t(k)];
      const Ends& x = old[std::size_t((i - lowest - k) / 2 - old_first)];
      sum.lower += w * (w > 0 ? x.lower : x.upper);
      sum.upper += w * (w > 0 ? x.upper : x.lower);
    }
    result.push_back(sum);
  }
  return result;
}

std::vector<std::vector<Ends>> transpose(const std::vector<std::vector<Ends>>& rows) {
  std::vector<std::vector<Ends>> result(rows.front().size());
  for (const auto& row : rows) {
    for (std::size_t j = 0; j < row.size(); ++j) result[j].push_back(row[j]);
  }
  return result;
}

/// The hulls of `size` successive elements.
std::vector<Ends> hulls(const std::vector<Ends>& data, int size) {
  std::vector<Ends> result;
  for (std::size_t i = 0; i + std::size_t(size) <= data.size(); ++i) {
    Ends hull = data[i];
    for (std::size_t k = i + 1; k < i + std::size_t(size); ++k)
      hull = {std::min(hull.lower, data[k].lower), std::max(hull.upper, data[k].upper)};
    result.push_back(hull);
  }
  return result;
}

}  // namespace

/// Data after `level` steps on which the limit on the cells reach 2^level <= a < 2 reach 2^level, 0 <= b < 2 reach 2^level depends.
ApproxCharacteristicMap::Field ApproxCharacteristicMap::field(const std::function<Number(int, int)>& data, bool by_a, bool by_b,
                                                              int level) const {
  const auto size = [&](bool difference) { return 2 * last_ - (dual_ ? 1 : 0) - (difference ? 1 : 0); };
  const auto last = [&](bool difference, int l) { return ((2 * reach()) << l) - 2 - reach() + size(difference); };
  Field field{0, -reach(), {}};
  for (int a = 0; a <= last(by_a, 0); ++a) {
    field.rows.emplace_back();
    for (int b = -reach(); b <= last(by_b, 0); ++b) field.rows.back().push_back(ends(data(a, b)));
  }
  const int lowest = dual_ ? 1 - last_ : -last_;
  for (int l = 1; l <= level; ++l) {
    const int first_a = (reach() << l) - reach();
    for (auto& row : field.rows)
      row = refined(row, -reach(), by_b ? derived_ : mask_, lowest + (by_b ? 1 : 0), -reach(), last(by_b, l));
    field.rows = transpose(field.rows);
    for (auto& row : field.rows)
      row = refined(row, field.first_a, by_a ? derived_ : mask_, lowest + (by_a ? 1 : 0), first_a, last(by_a, l));
    field.rows = transpose(field.rows);
    field.first_a = first_a;
  }
  return field;
}

ApproxCharacteristicMap::Margins ApproxCharacteristicMap::margins(int level) const {
  const auto limits = [&](const std::function<Number(int, int)>& data, bool by_a, bool by_b) {
    const auto size = [&](bool difference) { return 2 * last_ - (dual_ ? 1 : 0) - (difference ? 1 : 0); };
    std::vector<std::vector<Ends>> rows = field(data, by_a, by_b, level).rows;
    for (auto& row : rows) row = hulls(row, size(by_b));
    rows = transpose(rows);
    for (auto& row : rows) row = hulls(row, size(by_a));
    rows = transpose(rows);
    const double beyond = ((by_a ? derived_bound_ : mask_bound_) * (by_b ? derived_bound_ : mask_bound_) - 1) / 2;
    for (auto& row : rows) {
      for (Ends& e : row) {
        const double more = beyond * (e.upper - e.lower);
        e = {e.lower - more, e.upper + more};
      }
    }
    return rows;
  };
  const auto derivative = [&](Number Pair::*part, int da, int db) {
    return limits([&](int a, int b) { return at(a + da, b + db).*part - at(a, b).*part; }, da != 0, db != 0);
  };
  const auto xa = derivative(&Pair::x, 1, 0), ya = derivative(&Pair::y, 1, 0);
  const auto xb = derivative(&Pair::x, 0, 1), yb = derivative(&Pair::y, 0, 1);
  const Number c{cosine_, radius_, 0}, square = Number{1, 0, 0} - c * c;
  const auto inward = limits([&](int a, int b) { return c * at(a, b).x + square * at(a, b).y; }, false, false);
  double least_jacobian = 1e300, greatest_jacobian = 0, least_inward = 1e300, greatest_inward = 0;
  for (std::size_t i = 0; i < xa.size(); ++i) {
    for (std::size_t j = 0; j <= i + std::size_t(reach() << level); ++j) {
      const Ends left = product(xa[i][j], yb[i][j]), right = product(xb[i][j], ya[i][j]);
      least_jacobian = std::min(least_jacobian, left.lower - right.upper);
      greatest_jacobian = std::max(greatest_jacobian, left.upper - right.lower);
      least_inward = std::min(least_inward, inward[i][j].lower);
      greatest_inward = std::max(greatest_inward, inward[i][j].upper);
    }
  }
  return {least_jacobian / greatest_jacobian, least_inward / greatest_inward};
}

std::vector<std::vector<std::complex<double>>> ApproxCharacteristicMap::samples(int level) const {
  // Control points after some more steps are close to the limit; those of a dual scheme lie half a step beside the lines of the grid.
  constexpr int more = 3;
  const double sine = std::sqrt(1 - cosine_ * cosine_);
  const auto part = [&](Number Pair::*which) {
    return field([&](int a, int b) { return Number{(at(a, b).*which).value, 0, 0}; }, false, false, level + more);
  };
  const Field x = part(&Pair::x), y = part(&Pair::y);
  std::vector<std::vector<std::complex<double>>> result;
  const auto value = [&](const Field& f, int a, int b) {
    const auto one = [&](int i, int j) { return f.rows[std::size_t(i - f.first_a)][std::size_t(j - f.first_b)].lower; };
    return dual_ ? (one(a, b) + one(a - 1, b) + one(a, b - 1) + one(a - 1, b - 1)) / 4 : one(a, b);
  };
  for (int a = reach() << level; a <= (2 * reach()) << level; ++a) {
    result.emplace_back();
    for (int b = 0; b <= a; ++b) result.back().emplace_back(value(x, a << more, b << more), sine * value(y, a << more, b << more));
  }
  return result;
}

namespace {

/// Signs as clear as this are found by the checker, too, whose bounds are rigorous.
constexpr double clear = 0.02;

std::optional<int> clear_level(const ApproxCharacteristicMap& map, int most) {
  for (int level = 1; level <= most; ++level) {
    const auto [jacobian, inward] = map.margins(level);
    if (jacobian > clear && inward > clear) return level;
  }
  return std::nullopt;
}

bool append_pieces(const RingRule& rule, int rings, const Rational& from, const Rational& to, std::vector<MapPiece>& pieces, const Stop& stop) {
  stop.check();
  const double low = approx_double(from), high = approx_double(to);
  try {
    if (const auto level = clear_level({rule, rings, std::nullopt, (low + high) / 2, (high - low) / 2}, 4)) {
      pieces.push_back({to, *level});
      return true;
    }
  } catch (const DomainError&) {  // too wide
  }
  if (high - low < 1. / 1024) return false;
  const Rational middle = (from + to) / 2;
  return append_pieces(rule, rings, from, middle, pieces, stop) && append_pieces(rule, rings, middle, to, pieces, stop);
}

}  // namespace

std::optional<int> approx_map_level(const RingRule& rule, int rings, int valence) {
  return clear_level({rule, rings, valence, std::cos(std::numbers::pi / valence)}, 6);
}

std::vector<MapPiece> approx_map_pieces(const RingRule& rule, int rings, const Rational& start, const Stop& stop) {
  std::vector<MapPiece> pieces;
  return append_pieces(rule, rings, start, 1, pieces, stop) ? pieces : std::vector<MapPiece>{};
}

}  // namespace limes
