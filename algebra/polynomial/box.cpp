#include "algebra/polynomial/box.hpp"

#include "algebra/error.hpp"
#include "algebra/number/read_rational.hpp"

#include <algorithm>

namespace limes {

namespace {

[[noreturn]] void fail(const std::string& reason, std::size_t index) {
  throw InputError(reason, {"", 0, static_cast<int>(index) + 1});
}

/// The rational in text[from, to); columns of errors count in the whole text.
Rational rational_in(std::string_view text, std::size_t from, std::size_t to) {
  const auto moved = [&](const InputError& error) {
    return SourcePosition{"", 0, error.position().column + static_cast<int>(from)};
  };
  try {
    return read_rational(text.substr(from, to - from));
  } catch (const LimitError& error) {
    throw LimitError(error.reason(), moved(error));
  } catch (const InputError& error) {
    throw InputError(error.reason(), moved(error));
  }
}

void require_shape(std::size_t a, std::size_t b) {
  if (a != b) {
    throw DomainError("a box of dimension " + std::to_string(a) + " where " + std::to_string(b) + " is expected");
  }
}

}  // namespace

bool Interval::contains(const Rational& x) const {
  return (lower_open ? lower < x : lower <= x) && (upper_open ? x < upper : x <= upper);
}

bool Interval::contains(const Interval& other) const {
  const int below = lower.compare(other.lower), above = upper.compare(other.upper);
  return (below < 0 || (below == 0 && (!lower_open || other.lower_open))) &&
         (above > 0 || (above == 0 && (!upper_open || other.upper_open)));
}

Interval read_interval(std::string_view text) {
  constexpr const char* blanks = " \t\n\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) fail("expected an interval or a number, found nothing", 0);
  const std::size_t last = text.find_last_not_of(blanks);
  const char opening = text[first], closing = text[last];
  if (opening != '[' && opening != '(' && opening != '{') return Interval::point(read_rational(text));
  if (first == last) fail("the interval has no end", last + 1);
  if (opening == '{') {
    if (closing != '}') fail("expected '}' at the end", last);
    return Interval::point(rational_in(text, first + 1, last));
  }
  if (closing != ']' && closing != ')') fail("expected ']' or ')' at the end", last);
  const std::size_t comma = text.find(',', first);
  if (comma == std::string_view::npos) fail("expected a comma between the ends of the interval", last);
  Interval interval;
  interval.lower = rational_in(text, first + 1, comma);
  interval.upper = rational_in(text, comma + 1, last);
  interval.lower_open = opening == '(';
  interval.upper_open = closing == ')';
  if (interval.lower > interval.upper) fail("the lower end exceeds the upper one", comma + 1);
  if (interval.is_point() && (interval.lower_open || interval.upper_open)) fail("the interval is empty", first);
  return interval;
}

std::string to_string(const Interval& interval) {
  if (interval.is_point()) return to_string(interval.lower);
  return (interval.lower_open ? "(" : "[") + to_string(interval.lower) + ", " + to_string(interval.upper) +
         (interval.upper_open ? ")" : "]");
}

bool contains(const Box& box, std::span<const Rational> point) {
  require_shape(point.size(), box.size());
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (!box[i].contains(point[i])) return false;
  }
  return true;
}

bool contains(const Box& box, const Box& other) {
  require_shape(other.size(), box.size());
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (!box[i].contains(other[i])) return false;
  }
  return true;
}

std::vector<Rational> midpoint(const Box& box) {
  std::vector<Rational> result;
  result.reserve(box.size());
  for (const Interval& interval : box) result.push_back(interval.midpoint());
  return result;
}

bool is_point(const Box& box) {
  return std::all_of(box.begin(), box.end(), [](const Interval& interval) { return interval.is_point(); });
}

std::pair<Box, Box> bisect(const Box& box, int axis) {
  const auto k = static_cast<std::size_t>(axis);
  if (axis < 0 || k >= box.size() || box[k].is_point()) {
    throw DomainError("a box has no halves along axis " + std::to_string(axis));
  }
  std::pair<Box, Box> halves{box, box};
  const Rational cut = box[k].midpoint();
  halves.first[k].upper = cut;
  halves.first[k].upper_open = false;
  halves.second[k].lower = cut;
  halves.second[k].lower_open = false;
  return halves;
}

int widest_axis(const Box& box, const Box& reference) {
  require_shape(reference.size(), box.size());
  int widest = -1;
  Rational greatest = 0;
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (box[i].is_point()) continue;
    if (reference[i].is_point()) throw DomainError("the widest axis of a box relative to one that is a point there");
    const Rational relative = box[i].width() / reference[i].width();
    if (relative > greatest) {
      greatest = relative;
      widest = static_cast<int>(i);
    }
  }
  return widest;
}

}  // namespace limes
