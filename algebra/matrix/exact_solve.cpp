#include "algebra/matrix/exact_solve.hpp"

#include "algebra/error.hpp"
#include "algebra/number/flint_conversion.hpp"

#include <flint/fmpq_mat.h>

#include <fmt/format.h>

namespace limes {
namespace {

class FlintMatrix {
 public:
  FlintMatrix(int rows, int columns) { fmpq_mat_init(value, rows, columns); }
  explicit FlintMatrix(const RationalMatrix& a) : FlintMatrix(a.rows(), a.columns()) {
    for (int i = 0; i < a.rows(); ++i) {
      for (int j = 0; j < a.columns(); ++j) to_fmpq(fmpq_mat_entry(value, i, j), a(i, j));
    }
  }
  FlintMatrix(const FlintMatrix&) = delete;
  FlintMatrix& operator=(const FlintMatrix&) = delete;
  ~FlintMatrix() { fmpq_mat_clear(value); }

  fmpq_mat_t value;
};

}  // namespace

std::optional<RationalMatrix> exact_solve(const RationalMatrix& a, const RationalMatrix& b) {
  if (a.rows() != a.columns() || a.rows() != b.rows()) {
    throw DomainError(fmt::format("a system with a {} x {} matrix and a {} x {} right side", a.rows(), a.columns(),
                                  b.rows(), b.columns()));
  }
  clean_up_flint_at_thread_exit();
  const FlintMatrix left(a), right(b);
  FlintMatrix x(a.rows(), b.columns());
  if (!fmpq_mat_solve(x.value, left.value, right.value)) return std::nullopt;
  RationalMatrix result(a.rows(), b.columns());
  for (int i = 0; i < result.rows(); ++i) {
    for (int j = 0; j < result.columns(); ++j) result(i, j) = from_fmpq(fmpq_mat_entry(x.value, i, j));
  }
  return result;
}

}  // namespace limes
