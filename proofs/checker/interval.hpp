// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include <string>
#include <string_view>
#include <vector>

namespace limes::checker {

/// Thrown by the first step that fails; check() turns it into a Result.
struct Rejected {
  std::string step, reason;
};

/// What a certificate may cost: work in estimated nanoseconds *before* it is done, memory in bytes. start_leaf()
/// forgets the memory of the last leaf.
class Budget {
 public:
  void work(double nanoseconds) {
    if (!((work_ += nanoseconds) <= 2e10)) throw Rejected{"limits", "checking would take more than about 20 seconds"};
  }
  void hold(double bytes) {
    (in_leaf_ ? leaf_bytes_ : bytes_) += bytes;
    if (!(bytes_ + leaf_bytes_ <= 512e6)) throw Rejected{"limits", "checking would take too much memory"};
  }
  void start_leaf() { in_leaf_ = true, leaf_bytes_ = 0; }

 private:
  double work_ = 0, bytes_ = 0, leaf_bytes_ = 0;
  bool in_leaf_ = false;
};

/// The size of a number in machine words.
inline double limbs(const mpz_class& x) { return static_cast<double>(mpz_size(x.get_mpz_t())) + 1; }
inline double limbs(const mpq_class& x) { return limbs(x.get_num()) + limbs(x.get_den()); }

/// A place on the line just before or just after a rational. Cuts are totally ordered, and two different cuts have a
/// point between them; so inclusion and covering of intervals with open and closed ends is comparison of cuts.
struct Cut {
  mpq_class value;
  bool after = false;
  bool operator<(const Cut& y) const { return value < y.value || (value == y.value && !after && y.after); }
};

/// The points between two cuts; never empty. [p, q] runs from before p to after q, (p, q) from after p to before q.
struct Interval {
  Cut lower, upper;
  std::string text;  ///< as the certificate writes it
  bool is_point() const { return lower.value == upper.value; }
};

/// One interval for every parameter, in the order of the scheme's parameters.
using Region = std::vector<Interval>;

/// Untrusted text for a message: printable ASCII between quotes, shortened.
std::string quoted(std::string_view text);
/// `-?[0-9]+(/[0-9]+)?` with non-zero denominator and at most 10000 digits in either part. \throws Rejected at `step`
mpq_class read_rational(std::string_view text, const std::string& step);
/// `[p, q]`, `(p, q]`, `[p, q)`, `(p, q)` with p < q, or a rational. \throws Rejected at `step`
Interval read_interval(std::string_view text, const std::string& step);

bool is_inside(const Region& inner, const Region& outer);
/// Whether every point of the region lies in one of the leaves. \pre every leaf is inside the region
bool covers(const std::vector<Region>& leaves, const Region& region, Budget& budget);

}  // namespace limes::checker
