// SPDX-License-Identifier: MIT
//
// Polytope norms: let P be the convex hull of all multiples z v of vectors v_1 .. v_M, of their conjugates and of
// unit e_1 .. unit e_n with |z| = 1 (z = +-1 when all are real). If B v_i and B (unit e_k) lie in R P for every matrix of a family, then B P is in R P,
// so that all products of length l have norm <= R^l (Guglielmi & Protasov 2013). Membership is shown by a combination:
// for the exact remainder r = B v_i - sum_j c_j v_j, sum_j |c_j| + ||r||_1 / unit <= R.
#include "proofs/checker/polytope.hpp"

#include "proofs/checker/json.hpp"

namespace limes::checker {
namespace {

constexpr std::size_t max_size = 64, max_vectors = 20000, max_matrices = 64;

void require(bool condition, const std::string& reason) {
  if (!condition) throw Rejected{"polytope", reason};
}

}  // namespace

mpq_class modulus(const mpq_class& x, const mpq_class& y, Budget& budget) {
  if (y == 0) return abs(x);
  const double size = limbs(x) + limbs(y);
  budget.work(2000 + 20 * size * size);
  const mpq_class square = x * x + y * y;
  mpz_class scaled = square.get_num() << 128, root;
  mpz_cdiv_q(scaled.get_mpz_t(), scaled.get_mpz_t(), square.get_den_mpz_t());
  mpz_sqrt(root.get_mpz_t(), scaled.get_mpz_t());
  mpq_class result(root + 1, mpz_class(1) << 64);
  result.canonicalize();
  return result;
}

void subtract(Vector& x, const mpq_class& re, const mpq_class& im, const Vector& y, bool conjugated, Budget& budget) {
  const mpq_class minus_re = -re, minus_im = -im;
  for (std::size_t i = 0; i < y.real.size(); ++i) {
    add_product(x.real[i], minus_re, y.real[i], budget);
    if (im != 0) add_product(x.imaginary[i], minus_im, y.real[i], budget);
    if (y.imaginary.empty()) continue;
    add_product(x.real[i], conjugated ? minus_im : im, y.imaginary[i], budget);
    add_product(x.imaginary[i], conjugated ? re : minus_re, y.imaginary[i], budget);
  }
}

mpq_class read_number(const Json& value, const std::string& step, const std::string& what, Budget& budget) {
  if (!value.is_string()) throw Rejected{step, what + " needs strings as numbers"};
  const auto& text = value.get_ref<const std::string&>();
  budget.work(500 + 2. * static_cast<double>(text.size()) * static_cast<double>(text.size()));
  budget.hold(100 + 2. * static_cast<double>(text.size()));
  return read_rational(text, step);
}

void add_product(mpq_class& x, const mpq_class& y, const mpq_class& z, Budget& budget) {
  if (y == 0 || z == 0) {
    budget.work(10);
    return;
  }
  const double size = limbs(x) + limbs(y) + limbs(z);
  budget.work(150 + 4 * size * size);
  x += y * z;
}

RationalMatrix product(const RationalMatrix& a, const RationalMatrix& b, Budget& budget) {
  RationalMatrix result(a.rows, b.columns);
  for (std::size_t i = 0; i < a.rows; ++i)
    for (std::size_t k = 0; k < a.columns; ++k)
      for (std::size_t j = 0; j < b.columns; ++j) add_product(result.at(i, j), a.at(i, k), b.at(k, j), budget);
  return result;
}

Vector product(const RationalMatrix& b, const Vector& x, Budget& budget) {
  const std::size_t n = b.rows;
  Vector y{std::vector<mpq_class>(n), std::vector<mpq_class>(x.imaginary.size())};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      add_product(y.real[i], b.at(i, j), x.real[j], budget);
      if (!x.imaginary.empty()) add_product(y.imaginary[i], b.at(i, j), x.imaginary[j], budget);
    }
  }
  return y;
}

void prove_inside(Vector y, const mpq_class& error, const Json& terms, const Hull& hull, const mpq_class& bound,
                  const std::string& where, Budget& budget) {
  const std::string step = "polytope";
  const std::size_t n = y.real.size(), count = hull.vectors.size();
  if (!terms.is_array() || terms.size() > 2 * count) throw Rejected{step, where + ": needs a list of terms"};
  const mpq_class one = 1;
  mpq_class sum = 0, uncertainty = error;
  bool complex = !y.imaginary.empty();
  y.imaginary.resize(n);
  for (const Json& term : terms) {
    if (!term.is_array() || term.size() < 2 || term.size() > 3 || !term[0].is_number_unsigned())
      throw Rejected{step, where + ": a term is [index, number] or [index, number, number]"};
    const std::uint64_t index = term[0].get<std::uint64_t>();
    if (index >= 2 * count) throw Rejected{step, where + ": a term has an index that is too large"};
    const mpq_class re = read_number(term[1], step, where, budget);
    const mpq_class im = term.size() == 3 ? read_number(term[2], step, where, budget) : mpq_class(0);
    const mpq_class size = modulus(re, im, budget);
    complex = complex || im != 0;
    subtract(y, re, im, hull.vectors[index % count], index >= count, budget);
    add_product(sum, one, size, budget);
    if (!hull.errors.empty()) add_product(uncertainty, size, hull.errors[index % count], budget);
  }
  // Each coordinate of the remainder is off by at most the uncertainty (in the complex plane: both parts are).
  mpq_class remainder = 0;
  add_product(remainder, mpq_class((complex ? 2 : 1) * static_cast<unsigned long>(n)), uncertainty, budget);
  for (const auto* part : {&y.real, &y.imaginary})
    for (const mpq_class& entry : *part) add_product(remainder, one, abs(entry), budget);
  budget.work(1000 + 20 * limbs(remainder) * limbs(hull.unit));
  remainder /= hull.unit;
  add_product(sum, one, remainder, budget);
  budget.work(100 + 20 * limbs(sum) * limbs(bound));
  if (sum > bound) throw Rejected{step, where + ": the image is longer than the bound"};
}

RationalMatrix read_matrix(const Json& json, const std::string& step, const std::string& what, Budget& budget) {
  if (!json.is_array() || json.empty() || json.size() > max_size || !json[0].is_array() || json[0].empty() ||
      json[0].size() > max_size)
    throw Rejected{step, what + " is no list of 1 to " + std::to_string(max_size) + " rows"};
  RationalMatrix result(json.size(), json[0].size());
  for (std::size_t i = 0; i < result.rows; ++i) {
    if (!json[i].is_array() || json[i].size() != result.columns) throw Rejected{step, what + " has rows of different lengths"};
    for (std::size_t j = 0; j < result.columns; ++j) result.at(i, j) = read_number(json[i][j], step, what, budget);
  }
  return result;
}

Blocks diagonal_blocks(const std::vector<RationalMatrix>& family, const Json& json, Budget& budget) {
  const std::string step = "blocks";
  if (family.empty() || family.size() > max_matrices) throw Rejected{step, "the family is empty or too large"};
  const std::size_t n = family[0].rows;
  for (const auto& b : family)
    if (n == 0 || n > max_size || b.rows != n || b.columns != n) throw Rejected{step, "the matrices are not square of one size"};
  if (json.is_null()) return {{family}};
  const Reader reader(json, step, "the block form", {"basis", "inverse", "sizes"});
  const RationalMatrix basis = read_matrix(reader.at("basis"), step, "the basis", budget);
  const RationalMatrix inverse = read_matrix(reader.at("inverse"), step, "the inverse", budget);
  if (basis.rows != n || basis.columns != n || inverse.rows != n || inverse.columns != n)
    reader.fail("has a basis of another size");
  const RationalMatrix identity = product(inverse, basis, budget);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if (identity.at(i, j) != (i == j ? 1 : 0)) reader.fail("has an inverse that is none");
  std::vector<std::size_t> ends;
  std::size_t end = 0;
  for (const Json& size : reader.list("sizes", 1, n))
    ends.push_back(end += static_cast<std::size_t>(reader.integer(size, "a size", 1, static_cast<int>(n))));
  if (end != n) reader.fail("has sizes that do not add up");

  Blocks result{std::vector<std::vector<RationalMatrix>>(ends.size())};
  for (const auto& b : family) {
    const RationalMatrix c = product(product(inverse, b, budget), basis, budget);
    for (std::size_t k = 0, first = 0; k < ends.size(); first = ends[k++]) {
      RationalMatrix block(ends[k] - first, ends[k] - first);
      for (std::size_t i = first; i < n; ++i) {
        for (std::size_t j = first; j < ends[k]; ++j) {
          if (i < ends[k])
            block.at(i - first, j - first) = c.at(i, j);
          else if (c.at(i, j) != 0)
            reader.fail("is not block triangular");
        }
      }
      result.families[k].push_back(std::move(block));
    }
  }
  return result;
}

void prove_polytope(const std::vector<RationalMatrix>& family, const mpq_class& bound, const Json& json, Budget& budget) {
  const Reader reader(json, "polytope", "a polytope", {"vectors", "unit", "images"});
  const std::size_t n = family.at(0).rows;
  Hull hull;
  hull.unit = read_number(reader.at("unit"), "polytope", "the unit", budget);
  require(hull.unit > 0, "the unit is not positive");
  for (const Json& vector : reader.list("vectors", 0, max_vectors)) {
    require(vector.is_array() && (vector.size() == n || vector.size() == 2 * n), "a vector has a wrong length");
    Vector v;
    for (const Json& entry : vector)
      (v.real.size() < n ? v.real : v.imaginary).push_back(read_number(entry, "polytope", "a vector", budget));
    hull.vectors.push_back(std::move(v));
  }
  const std::size_t count = hull.vectors.size();
  const Json& images = reader.list("images", family.size(), family.size());
  for (std::size_t e = 0; e < family.size(); ++e) {
    require(images[e].is_array() && images[e].size() == count + n, "the images of a matrix have a wrong number");
    for (std::size_t i = 0; i < count + n; ++i) {
      Vector unit{std::vector<mpq_class>(n), {}};
      if (i >= count) unit.real[i - count] = hull.unit;
      const std::string where = "matrix " + std::to_string(e) + ", vector " + std::to_string(i);
      prove_inside(product(family[e], i < count ? hull.vectors[i] : unit, budget), 0, images[e][i], hull, bound, where, budget);
    }
  }
}

void prove_polytope_norm(const std::vector<RationalMatrix>& family, const mpq_class& bound, const Json& norm, Budget& budget) {
  const Reader reader(norm, "polytope", "the norm", {"form", "blocks"});
  const Blocks blocks = diagonal_blocks(family, reader.at("form"), budget);
  const Json& polytopes = reader.list("blocks", blocks.families.size(), blocks.families.size());
  for (std::size_t k = 0; k < blocks.families.size(); ++k) prove_polytope(blocks.families[k], bound, polytopes[k], budget);
}

}  // namespace limes::checker
