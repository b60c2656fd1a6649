// SPDX-License-Identifier: MIT
//
// Theorem P2: under the hypotheses of theorem P1, let a product A_W of k sections have the positive eigenvector v_1 in the cone,
// A_W v_1 = lambda_1 v_1 (so lambda_1 is simple and strictly dominant), and a real eigenvector v_2 with 2^-k < |lambda_2| / lambda_1 < 1.
// The points v_2 with weights 1 give, after r times W, multiples (lambda_2 / lambda_1)^r of points close to v_2 / v_1, at distance
// O(2^-rk) of one point where the limit is 0. When the limit of v_2 / v_1 does not vanish in some window, it is no C^1 function.
#include "proofs/checker/projective.hpp"

#include "proofs/checker/theorems.hpp"

#include <cmath>

namespace limes::checker {
namespace {

using Vector = std::vector<mpq_class>;

struct Bounds {
  mpq_class lower, upper;
};

/// An eigenvector and its value, each number known up to `radius`.
struct Eigenpair {
  Vector vector;
  mpq_class value, radius;
  Bounds of(std::size_t i) const { return {vector[i] - radius, vector[i] + radius}; }
};

/// The product of the word, exactly.
Vector rational_product(const Sections& scheme, const std::vector<int>& word, Budget& budget) {
  const IntegerMatrix integers = apply_word(scheme, word, budget);
  mpz_class scale;
  mpz_pow_ui(scale.get_mpz_t(), scheme.denominator.get_mpz_t(), word.size());
  Vector matrix;
  for (const auto& x : integers) {
    budget.work(500 + 20 * limbs(x) * limbs(scale));
    matrix.emplace_back(x, scale);
    matrix.back().canonicalize();
  }
  return matrix;
}

/// x, rounded to a multiple of 2^-bits.
mpq_class rounded(const mpq_class& x, unsigned bits) {
  mpz_class numerator = x.get_num() << bits;
  mpz_fdiv_q(numerator.get_mpz_t(), numerator.get_mpz_t(), x.get_den().get_mpz_t());
  mpq_class result(numerator, mpz_class(1) << bits);
  result.canonicalize();
  return result;
}

/// An approximate inverse of an n x n matrix, by elimination in floating point of 256 bits: any matrix will do that passes the test below.
/// \throws Rejected when no pivot is found
Vector approximate_inverse(const Vector& matrix, std::size_t n, Budget& budget) {
  constexpr unsigned precision = 256;
  const auto size = static_cast<double>(n);
  budget.work(size * size * size * 600);
  std::vector<mpf_class> a, result;
  for (const auto& x : matrix) {
    a.emplace_back(x, precision);
    result.emplace_back(a.size() % (n + 1) == 1 ? 1 : 0, precision);
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i)
      if (abs(a[i * n + k]) > abs(a[pivot * n + k])) pivot = i;
    if (a[pivot * n + k] == 0) throw Rejected{"eigenvector", "the Jacobian of the eigenvalue problem is singular"};
    const mpf_class head = 1 / a[pivot * n + k];
    for (std::size_t j = 0; j < n; ++j) {
      std::swap(a[pivot * n + j], a[k * n + j]);
      std::swap(result[pivot * n + j], result[k * n + j]);
      a[k * n + j] *= head;
      result[k * n + j] *= head;
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || a[i * n + k] == 0) continue;
      const mpf_class factor = a[i * n + k];
      for (std::size_t j = 0; j < n; ++j) {
        a[i * n + j] -= factor * a[k * n + j];
        result[i * n + j] -= factor * result[k * n + j];
      }
    }
  }
  Vector inverse;
  for (const auto& x : result) {
    if (abs(x) > mpf_class("1e60")) throw Rejected{"eigenvector", "the Jacobian of the eigenvalue problem is nearly singular"};
    inverse.push_back(rounded(mpq_class(x), 192));
  }
  return inverse;
}

/// An exact eigenpair near the given one (Newton, Kantorovich): with one component fixed to 1, unknowns x = (the others, lambda),
/// F(x) = A v - lambda v and an approximation C of the inverse of J = F'(x), h -> -C (F(x) + (J - C^-1) h - h_lambda h_v) maps the ball
/// of radius r into itself if |C F| + |I - C J| r + |C| r^2 <= r; C is regular if |I - C J| < 1.
Eigenpair verified_eigenpair(const Vector& matrix, std::size_t n, const Reader& proof, const char* key, Budget& budget) {
  const Reader reader(proof.at(key), "proof", std::string("the eigenpair ") + key, {"value", "vector"});
  const auto number = [&](const Json& json) {
    const std::string& text = reader.text(json, "a number");
    if (text.size() > 400) reader.fail("has numbers of more than 400 characters");
    return read_rational(text, "proof");
  };
  Eigenpair pair{{}, number(reader.at("value")), 0};
  for (const Json& entry : reader.list("vector", n, n)) pair.vector.push_back(number(entry));
  const auto one = std::find(pair.vector.begin(), pair.vector.end(), mpq_class(1));
  if (one == pair.vector.end()) throw Rejected{"eigenvector", "no component of an eigenvector is 1"};
  const auto fixed = static_cast<std::size_t>(one - pair.vector.begin());

  Vector residual(n), jacobian = matrix;
  for (std::size_t i = 0; i < n; ++i) {
    residual[i] = -pair.value * pair.vector[i];
    for (std::size_t j = 0; j < n; ++j) {
      budget.work(500 + 4 * limbs(matrix[i * n + j]) * limbs(pair.vector[j]) + 8 * limbs(residual[i]));
      residual[i] += matrix[i * n + j] * pair.vector[j];
    }
    jacobian[i * n + i] -= pair.value;
    jacobian[i * n + fixed] = -pair.vector[i];
  }
  const Vector c = approximate_inverse(jacobian, n, budget);
  mpq_class start = 0, defect = 0, norm = 0;
  for (std::size_t i = 0; i < n; ++i) {
    mpq_class newton = 0, row_defect = 0, row_norm = 0;
    for (std::size_t j = 0; j < n; ++j) {
      mpq_class entry = i == j ? 1 : 0;
      for (std::size_t k = 0; k < n; ++k) {
        budget.work(500 + 4 * limbs(c[i * n + k]) * limbs(jacobian[k * n + j]) + 8 * limbs(entry));
        entry -= c[i * n + k] * jacobian[k * n + j];
      }
      newton += c[i * n + j] * residual[j];
      row_defect += abs(entry);
      row_norm += abs(c[i * n + j]);
    }
    start = std::max(start, mpq_class(abs(newton)));
    defect = std::max(defect, row_defect);
    norm = std::max(norm, row_norm);
  }
  pair.radius = rounded(2 * start, 256) + mpq_class(1, mpz_class(1) << 256);
  if (defect >= 1 || start + defect * pair.radius + norm * pair.radius * pair.radius > pair.radius)
    throw Rejected{"eigenvector", "no eigenvector is proved to lie near the given one"};
  return pair;
}

/// The i-th component of matrix v for an eigenvector known up to its radius.
Bounds image(const Vector& matrix, std::size_t n, std::size_t i, const Eigenpair& pair, Budget& budget) {
  mpq_class middle = 0, spread = 0;
  for (std::size_t j = 0; j < n; ++j) {
    budget.work(500 + 4 * limbs(matrix[i * n + j]) * limbs(pair.vector[j]) + 8 * limbs(middle));
    middle += matrix[i * n + j] * pair.vector[j];
    spread += abs(matrix[i * n + j]);
  }
  return {middle - spread * pair.radius, middle + spread * pair.radius};
}

/// The limit of the points A_U v_2 / A_U v_1 keeps away from zero: it differs from the middle of the window's points by at most
/// norm / 2 times their oscillation times the sum of the powers of the contraction factor; with norm 1 it lies between them.
void prove_visible(const Vector& window, std::size_t n, const Eigenpair& first, const Eigenpair& second, const Contraction& contraction,
                   Budget& budget) {
  mpq_class least, greatest;
  for (std::size_t i = 0; i < n; ++i) {
    const Bounds x = image(window, n, i, second, budget), y = image(window, n, i, first, budget);
    if (y.lower <= 0) throw Rejected{"visible", "a weight of the window is not proved positive"};
    const mpq_class lower = x.lower / (x.lower < 0 ? y.lower : y.upper), upper = x.upper / (x.upper < 0 ? y.upper : y.lower);
    if (i == 0 || lower < least) least = lower;
    if (i == 0 || upper > greatest) greatest = upper;
  }
  if (contraction.norm == 1 && (least > 0 || greatest < 0)) return;
  const mpq_class reach = contraction.norm * (greatest - least) / (2 * (1 - contraction.factor));
  if (abs(least + greatest) / 2 <= reach) throw Rejected{"visible", "the limit in the window is not proved different from zero"};
}

}  // namespace

std::string check_p2(const Json& json, Budget& budget) {
  const MaskClaim claim = read_mask_claim(json, budget);
  if (smoothness_in(claim.statement, claim.certified ? "not projective " : "projective ") < 1)
    throw Rejected{"claim", "theorem P2 certifies \"not projective C<m>\" or refutes \"projective C<m>\", m >= 1"};
  const Reader proof(json.at("proof"), "proof", "the proof", {"cone", "level", "word", "dominant", "second", "window"});
  const std::size_t n = claim.scheme.size;
  const Cone cone = read_cone(proof, n, budget);
  const int level = proof.integer(proof.at("level"), "level", 1, 12);
  const std::vector<int> word = read_word(proof, "word", 1, 24), window = read_word(proof, "window", 0, 48);
  if (window.size() % static_cast<std::size_t>(level) != 0) throw Rejected{"visible", "the window's length is no multiple of the level"};
  const Contraction contraction = prove_contraction(claim.scheme, cone, level, budget);

  const Vector matrix = rational_product(claim.scheme, word, budget);
  const Eigenpair first = verified_eigenpair(matrix, n, proof, "dominant", budget);
  const Eigenpair second = verified_eigenpair(matrix, n, proof, "second", budget);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if (cone.lower[j] * first.of(i).upper >= cone.upper[i] * first.of(j).lower)
        throw Rejected{"dominant", "the dominant eigenvector does not lie inside of the cone"};
  const mpq_class modulus = abs(second.value);
  if (first.value - first.radius <= modulus + second.radius)
    throw Rejected{"second", "the second eigenvalue is not proved smaller than the dominant one"};
  mpq_class scaled = modulus - second.radius;
  mpq_mul_2exp(scaled.get_mpq_t(), scaled.get_mpq_t(), word.size());
  if (scaled <= first.value + first.radius)
    throw Rejected{"second", "the quotient of the eigenvalues is not proved greater than 2^-k"};
  prove_visible(rational_product(claim.scheme, window, budget), n, first, second, contraction, budget);
  return mask_statement(claim, "not projective C1", "P2");
}

}  // namespace limes::checker
