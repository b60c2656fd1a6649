#include "geometry/line_transform_impl.hpp"

#include "algebra/error.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace limes::pyramid_impl {
namespace {

/// The filter whose entry 0 stands at `start`, trimmed.
PlacedFilter placed(const std::vector<Rational>& filter, int start) {
  std::size_t first = 0, last = filter.size();
  while (first < last && filter[first] == 0) ++first;
  while (last > first && filter[last - 1] == 0) --last;
  PlacedFilter result{start + static_cast<int>(first), {}};
  for (std::size_t i = first; i < last; ++i) result.taps.push_back(approx_double(filter[i]));
  return result;
}

int floor_half(int x) { return (x - (x & 1)) / 2; }

void finish(Polyphase& phases) {
  for (const auto& taps : phases.outputs) {
    for (const Tap& tap : taps) {
      phases.before = std::max(phases.before, -tap.offset);
      phases.after = std::max(phases.after, tap.offset);
    }
  }
}

}  // namespace

PlacedBank::PlacedBank(const FilterBank& bank) {
  // P: without its zeros of odd length about 2i, of even length about 2i + 1/2. B, the same filter mirrored with alternating
  // signs, about 2i + 1 or 2i + 1/2: the numbering of the details is ours to choose, in steps of one.
  p = placed(bank.p, 0);
  const int length = static_cast<int>(p.taps.size()), origin = p.start + (length - 1) / 2;
  p.start -= origin;
  a = placed(bank.a, bank.shift - origin);
  b = placed(bank.b, bank.shift - origin);
  q = placed(bank.q, -origin);
  const int wanted = length % 2 == 0 ? p.start : p.start + 1;
  const int move = 2 * floor_half(wanted - b.start);
  b.start += move;
  q.start += move;
  for (const auto& [filter, output] : {std::pair{&a, 0}, std::pair{&b, 1}}) {
    for (std::size_t m = 0; m < filter->taps.size(); ++m) {
      const int x = filter->start + static_cast<int>(m);
      if (filter->taps[m] != 0)
        analysis.outputs[std::size_t(output)].push_back({x & 1, floor_half(x), filter->taps[m]});
    }
  }
  for (const auto& [filter, source] : {std::pair{&p, 0}, std::pair{&q, 1}}) {
    for (std::size_t m = 0; m < filter->taps.size(); ++m) {
      const int x = filter->start + static_cast<int>(m);
      if (filter->taps[m] != 0)
        synthesis.outputs[std::size_t(x & 1)].push_back({source, -floor_half(x), filter->taps[m]});
    }
  }
  finish(analysis);
  finish(synthesis);
}

std::size_t continued(long x, std::size_t size, Boundary boundary) {
  const long n = static_cast<long>(size), period = boundary == Boundary::periodic      ? n
                                                   : boundary == Boundary::half_sample ? 2 * n
                                                                                       : std::max(1L, 2 * n - 2);
  x = ((x % period) + period) % period;
  if (x >= n) x = period - x - (boundary == Boundary::half_sample ? 1 : 0);
  return static_cast<std::size_t>(x);
}

namespace {

/// The system for some of the unknown fine points; every row of A and B that meets one of them takes part.
EndSystem end_system(const PlacedBank& bank, std::size_t size, Boundary boundary, std::vector<std::size_t> unknown) {
  const long half = static_cast<long>(size / 2);
  std::vector<int> place(size, -1);
  for (std::size_t k = 0; k < unknown.size(); ++k) place[unknown[k]] = static_cast<int>(k);
  EndSystem system{std::move(unknown), {}, {}, {}};
  std::vector<std::vector<std::pair<std::size_t, double>>> rows;
  for (const auto& [filter, output] : {std::pair{&bank.a, 0L}, std::pair{&bank.b, 1L}}) {
    for (long i = 0; i < half; ++i) {
      std::vector<std::pair<std::size_t, double>> row;
      bool meets = false;
      for (std::size_t m = 0; m < filter->taps.size(); ++m) {
        const std::size_t x = continued(2 * i + filter->start + static_cast<long>(m), size, boundary);
        row.emplace_back(x, filter->taps[m]);
        meets = meets || place[x] >= 0;
      }
      if (!meets) continue;
      for (const auto& [x, weight] : row) {
        if (place[x] < 0 && std::find(system.known.begin(), system.known.end(), x) == system.known.end())
          system.known.push_back(x);
      }
      rows.push_back(std::move(row));
      system.transformed.push_back(static_cast<std::size_t>(i + output * half));
    }
  }
  std::sort(system.known.begin(), system.known.end());
  const auto count = [](const auto& list) { return static_cast<Eigen::Index>(list.size()); };
  Eigen::MatrixXd on_unknown = Eigen::MatrixXd::Zero(count(rows), count(system.unknown)),
                  right = Eigen::MatrixXd::Zero(count(rows), count(rows) + count(system.known));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    right(Eigen::Index(r), Eigen::Index(r)) = 1;
    for (const auto& [x, weight] : rows[r]) {
      if (place[x] >= 0) {
        on_unknown(Eigen::Index(r), place[x]) += weight;
      } else {
        const auto at = std::lower_bound(system.known.begin(), system.known.end(), x) - system.known.begin();
        right(Eigen::Index(r), count(rows) + at) -= weight;
      }
    }
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factored(on_unknown);
  factored.setThreshold(1e-9);
  if (factored.rank() < count(system.unknown))
    throw InputError("these filters have no inverse at the ends of open data: use --closed or the other --ends");
  const Eigen::MatrixXd solution = factored.solve(right);
  for (Eigen::Index u = 0; u < solution.rows(); ++u) {
    for (Eigen::Index k = 0; k < solution.cols(); ++k) system.weights.push_back(solution(u, k));
  }
  return system;
}

}  // namespace

std::vector<EndSystem> end_systems(const PlacedBank& bank, std::size_t size, Boundary boundary) {
  if (boundary == Boundary::periodic) return {};
  // Column j of P or Q begins at 2j + start: columns before 0 reach up to -3 + start + length, columns from size/2 on begin
  // at size + start.
  long left = 0, right = 0;
  for (const PlacedFilter* filter : {&bank.p, &bank.q}) {
    left = std::max(left, filter->start + static_cast<long>(filter->taps.size()) - 2);
    right = std::max(right, -static_cast<long>(filter->start));
  }
  const auto n = static_cast<long>(size);
  const auto points = [](long from, long to) {
    std::vector<std::size_t> result;
    for (long x = from; x < to; ++x) result.push_back(static_cast<std::size_t>(x));
    return result;
  };
  // Rows that meet the left unknowns end before the right ones begin.
  const long reach = static_cast<long>(std::max(bank.a.taps.size(), bank.b.taps.size())) + 2;
  if (left + right + 2 * reach >= n) {
    std::vector<std::size_t> all = points(0, std::min(left, n));
    for (long x = std::max({left, n - right, 0L}); x < n; ++x) all.push_back(static_cast<std::size_t>(x));
    return all.empty() ? std::vector<EndSystem>{}
                       : std::vector<EndSystem>{end_system(bank, size, boundary, std::move(all))};
  }
  std::vector<EndSystem> result;
  if (left > 0) result.push_back(end_system(bank, size, boundary, points(0, left)));
  if (right > 0) result.push_back(end_system(bank, size, boundary, points(n - right, n)));
  return result;
}

}  // namespace limes::pyramid_impl
