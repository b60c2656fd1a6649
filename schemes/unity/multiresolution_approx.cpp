// Constrained least squares by orthogonal factorisations, in double precision and in MPFR.
#include "algebra/error.hpp"
#include "schemes/unity/mpfr_impl.hpp"
#include "schemes/unity/multiresolution_impl.hpp"

#include <Eigen/QR>

namespace limes::multiresolution_impl {
namespace {

/// Eq. 41 for all right sides at once: C q = e_i exactly, ||M q|| least. With the pseudo-inverse Q_0 of C, whose rows are
/// independent, and its null space N, all solutions are the columns of Q_0 + N Y.
template <class T>
std::vector<Candidate> approx_candidates(const std::vector<Rational>& mask, int extension) {
  using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;
  const int K = static_cast<int>(mask.size()), rows = K - 1 - extension / 2, freedom = extension / 2 + 1;
  std::vector<T> p;
  for (const Rational& x : mask) p.push_back(from_rational<T>(x));
  Matrix C = Matrix::Zero(rows, K), M = Matrix::Zero(K - 1, K), N = Matrix::Zero(K, freedom);
  for (int i = 1; i < K; ++i) {
    for (int j = 1; j <= K; ++j) {
      const int b = 2 * i - j + 1, m = K - 2 * i + j;  // entries of p, counted from 1
      if (i <= rows && b >= 1 && b <= K)
        C(i - 1, j - 1) = j % 2 == 0 ? p[std::size_t(b - 1)] : T(-p[std::size_t(b - 1)]);
      if (m >= 1 && m <= K) M(i - 1, j - 1) = p[std::size_t(m - 1)];
    }
  }
  for (int t = 0; t < freedom; ++t) {
    for (int j = 2 * t; j < K; ++j) N(j, t) = p[std::size_t(j - 2 * t)];
  }
  const Eigen::HouseholderQR<Matrix> transposed(C.transpose());
  const Matrix R = transposed.matrixQR().topRows(rows).template triangularView<Eigen::Upper>();
  const Matrix thin = transposed.householderQ() * Matrix::Identity(K, rows);
  const Matrix Q0 = thin * R.transpose().template triangularView<Eigen::Lower>().solve(Matrix::Identity(rows, rows));
  const Matrix Y = Matrix(M * N).householderQr().solve(Matrix(M * Q0));
  const Matrix Q = Q0 - N * Y, residuals = M * Q, defect = C * Q - Matrix::Identity(rows, rows);

  // The residual of the hard constraints must be rounding only.
  using std::sqrt;
  const T scale = 1 + Q.cwiseAbs().maxCoeff();
  if (!(defect.cwiseAbs().maxCoeff() <= sqrt(Eigen::NumTraits<T>::epsilon()) * scale)) {
    throw InputError("the hard constraints BQ = I are too ill-conditioned for this precision: use exact arithmetic");
  }
  std::vector<Candidate> result;
  for (int i = 0; i < rows; ++i) {
    Candidate candidate{2 * (i + 1) - K, {}, exact_rational(T(residuals.col(i).squaredNorm()))};
    for (int j = 0; j < K; ++j) candidate.q.push_back(exact_rational(T(Q(j, i))));
    result.push_back(std::move(candidate));
  }
  return result;
}

}  // namespace

std::vector<Candidate> approx_candidates_binary64(const std::vector<Rational>& p, int extension) {
  return approx_candidates<double>(p, extension);
}

std::vector<Candidate> approx_candidates_multiprecision(const std::vector<Rational>& p, int extension, int digits) {
  const PrecisionScope precision(digits);
  return approx_candidates<Mpfr>(p, extension);
}

}  // namespace limes::multiresolution_impl
