// SPDX-License-Identifier: MIT
//
// Exact polytopes: alpha > 0 is a root of a polynomial M over Q in an interval [l, u]; vectors have entries in Q[x] / M, which stand for
// their values at x = alpha. An identity modulo M holds at alpha. B_word v_0 = +-alpha^k v_0 with v_0 != 0 shows that the joint
// spectral radius is at least alpha; and that it is at most alpha is shown by a polytope as in polytope.cpp, in which an image is
// +-alpha v_j by an identity modulo M, or is strictly inside: then rational enclosures of the vectors suffice.
#include "proofs/checker/json.hpp"
#include "proofs/checker/polytope.hpp"

namespace limes::checker {
namespace {

using Element = std::vector<mpq_class>;  // of Q[x] / M: degree() coefficients
using ElementVector = std::vector<Element>;

void require(bool condition, const std::string& reason) {
  if (!condition) throw Rejected{"exact_polytope", reason};
}

/// Q[x] / M with an interval that holds the root alpha of M.
class Ring {
 public:
  Ring(const Reader& reader, Budget& budget) : budget_(budget) {
    for (const Json& c : reader.list("polynomial", 2, 65)) m_.push_back(number(c, "the polynomial"));
    require(m_.back() != 0 && m_.front() != 0, "the polynomial has a zero at the end");
    const Json& ends = reader.list("interval", 2, 2);
    lower_ = number(ends[0], "the interval");
    upper_ = number(ends[1], "the interval");
    require(0 < lower_ && lower_ <= upper_, "the interval is not one of positive numbers");
    const mpq_class at_lower = value(m_, lower_), at_upper = value(m_, upper_);
    require(at_lower == 0 ? lower_ == upper_ : sgn(at_lower) * sgn(at_upper) < 0, "the polynomial has no proven root in the interval");
    budget_.work(1000 + 20 * limbs(m_.front()) * limbs(m_.back()));
  }

  std::size_t degree() const { return m_.size() - 1; }
  const std::vector<mpq_class>& polynomial() const { return m_; }
  const mpq_class& lower() const { return lower_; }
  const mpq_class& upper() const { return upper_; }

  mpq_class number(const Json& json, const std::string& what) const { return read_number(json, "exact_polytope", what, budget_); }
  Element element(const Json& json) const {
    require(json.is_array() && json.size() <= degree(), "an entry of a start has too many coefficients");
    Element result(degree());
    for (std::size_t i = 0; i < json.size(); ++i) result[i] = number(json[i], "a start");
    return result;
  }
  /// x a.
  Element times_x(const Element& a) const {
    Element result(degree());
    for (std::size_t i = 0; i + 1 < degree(); ++i) result[i + 1] = a[i];
    eliminate(result, a.back(), m_.back(), 0);
    return result;
  }
  /// a / x: subtract the multiple of M that makes the constant coefficient zero.
  Element divided_by_x(const Element& a) const {
    Element result(degree());
    for (std::size_t i = 1; i < degree(); ++i) result[i - 1] = a[i];
    eliminate(result, a.front(), m_.front(), 1);
    return result;
  }
  ElementVector image(const RationalMatrix& b, const ElementVector& v) const {
    ElementVector result(b.rows, Element(degree()));
    for (std::size_t i = 0; i < b.rows; ++i)
      for (std::size_t j = 0; j < b.columns; ++j)
        for (std::size_t k = 0; k < degree(); ++k) add_product(result[i][k], b.at(i, j), v[j][k], budget_);
    return result;
  }
  /// The value at the middle of the interval, rounded down to a multiple of 2^-192; the value at alpha is within `error`.
  mpq_class enclose(const Element& a, mpq_class& error) const {
    mpq_class exact = value(a, (lower_ + upper_) / 2), slope = 0, power = 1;
    for (std::size_t i = 1; i < a.size(); ++i) {
      add_product(slope, static_cast<unsigned long>(i) * abs(a[i]), power, budget_);
      budget_.work(200 + 4 * limbs(power) * limbs(upper_));
      power *= upper_;
    }
    budget_.work(1000 + 40 * limbs(exact) * limbs(exact));
    mpz_class scaled = exact.get_num() << 192;
    mpz_fdiv_q(scaled.get_mpz_t(), scaled.get_mpz_t(), exact.get_den_mpz_t());
    const mpq_class unit(mpz_class(1), mpz_class(1) << 192);
    mpq_class center(scaled);
    center *= unit;
    error = unit;
    add_product(error, upper_ - lower_, slope, budget_);
    return center;
  }

 private:
  /// Adds -c / d (M without its last coefficient, or, shifted down by `shift` = 1, without its first).
  void eliminate(Element& a, const mpq_class& c, const mpq_class& d, std::size_t shift) const {
    if (c == 0) return;
    budget_.work(500 + 20 * limbs(c) * limbs(d));
    const mpq_class factor = -c / d;
    for (std::size_t i = 0; i < degree(); ++i) add_product(a[i], factor, m_[i + shift], budget_);
  }
  mpq_class value(const std::vector<mpq_class>& p, const mpq_class& x) const {
    mpq_class result = 0;
    for (std::size_t i = p.size(); i-- > 0;) {
      mpq_class next = p[i];
      add_product(next, result, x, budget_);
      result = std::move(next);
    }
    return result;
  }

  Budget& budget_;
  std::vector<mpq_class> m_;
  mpq_class lower_, upper_;
};

bool equal(const ElementVector& x, const ElementVector& y, int sign) {
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t k = 0; k < x[i].size(); ++k)
      if (x[i][k] != (sign > 0 ? y[i][k] : mpq_class(-y[i][k]))) return false;
  return true;
}

std::vector<ElementVector> read_vectors(const Reader& reader, const std::vector<RationalMatrix>& family, const Ring& ring,
                                        Budget& budget) {
  const std::size_t n = family[0].rows;
  std::vector<ElementVector> vectors;
  for (const Json& start : reader.list("starts", 1, 1000)) {
    require(start.is_array() && start.size() == n, "a start has a wrong length");
    ElementVector v;
    for (const Json& entry : start) v.push_back(ring.element(entry));
    vectors.push_back(std::move(v));
  }
  for (const Json& edge : reader.list("tree", 0, 20000)) {
    require(edge.is_array() && edge.size() == 2, "an edge of the tree is no pair");
    const int parent = reader.integer(edge[0], "a parent", 0, static_cast<int>(vectors.size()) - 1);
    const int letter = reader.integer(edge[1], "a letter", 0, static_cast<int>(family.size()) - 1);
    ElementVector v = ring.image(family[static_cast<std::size_t>(letter)], vectors[static_cast<std::size_t>(parent)]);
    for (Element& entry : v) {
      entry = ring.divided_by_x(entry);
      for (const mpq_class& c : entry) budget.hold(32 + 8 * limbs(c));
    }
    vectors.push_back(std::move(v));
  }
  return vectors;
}

/// B_word v = sign alpha^k v and v(alpha) != 0.
void prove_eigenvector(const Reader& reader, const std::vector<RationalMatrix>& family, const Ring& ring, const ElementVector& v,
                       const Hull& hull) {
  const int sign = reader.integer(reader.at("sign"), "the sign", -1, 1);
  require(sign != 0, "the sign is 0");
  const Json& word = reader.list("word", 1, 64);
  ElementVector image = v, power = v;
  for (std::size_t k = word.size(); k-- > 0;) {
    const int letter = reader.integer(word[k], "a letter", 0, static_cast<int>(family.size()) - 1);
    image = ring.image(family[static_cast<std::size_t>(letter)], image);
    for (Element& entry : power) entry = ring.times_x(entry);
  }
  require(equal(image, power, sign), "the first start is no eigenvector of the word's product");
  bool nonzero = false;
  for (const mpq_class& entry : hull.vectors[0].real) nonzero = nonzero || abs(entry) > hull.errors[0];
  require(nonzero, "the first start is not proved to be different from 0");
}

}  // namespace

RadiusBounds prove_exact_polytope(const std::vector<RationalMatrix>& family, const Json& json, Budget& budget) {
  const Reader reader(json, "exact_polytope", "an exact polytope",
                      {"polynomial", "interval", "word", "sign", "starts", "tree", "unit", "images"});
  const Ring ring(reader, budget);
  const std::vector<ElementVector> vectors = read_vectors(reader, family, ring, budget);
  const std::size_t n = family[0].rows, count = vectors.size();
  Hull hull{{}, ring.number(reader.at("unit"), "the unit"), {}};
  require(hull.unit > 0, "the unit is not positive");
  for (const ElementVector& v : vectors) {
    Vector center{std::vector<mpq_class>(n), {}};
    mpq_class greatest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      mpq_class error;
      center.real[i] = ring.enclose(v[i], error);
      if (error > greatest) greatest = error;
    }
    hull.vectors.push_back(std::move(center));
    hull.errors.push_back(std::move(greatest));
  }
  prove_eigenvector(reader, family, ring, vectors[0], hull);

  const Json& images = reader.list("images", family.size(), family.size());
  for (std::size_t e = 0; e < family.size(); ++e) {
    require(images[e].is_array() && images[e].size() == count + n, "the images of a matrix have a wrong number");
    mpq_class row_sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      mpq_class sum = 0;
      for (std::size_t j = 0; j < n; ++j) add_product(sum, 1, abs(family[e].at(i, j)), budget);
      if (sum > row_sum) row_sum = sum;
    }
    for (std::size_t i = 0; i < count + n; ++i) {
      const std::string where = "matrix " + std::to_string(e) + ", vector " + std::to_string(i);
      const Json& image = images[e][i];
      if (i < count && image.is_number_integer()) {
        const int index = reader.integer(image, "a vector", -static_cast<int>(count), static_cast<int>(count));
        require(index != 0, where + ": vectors count from 1");
        ElementVector scaled = vectors[static_cast<std::size_t>(std::abs(index) - 1)];
        for (Element& entry : scaled) entry = ring.times_x(entry);
        require(equal(ring.image(family[e], vectors[i]), scaled, index), where + ": the image is not that multiple of a vector");
        continue;
      }
      Vector unit{std::vector<mpq_class>(n), {}};
      if (i >= count) unit.real[i - count] = hull.unit;
      mpq_class error = 0;
      if (i < count) add_product(error, row_sum, hull.errors[i], budget);
      prove_inside(product(family[e], i < count ? hull.vectors[i] : unit, budget), error, image, hull, ring.lower(), where, budget);
    }
  }
  return {ring.lower(), ring.upper(), ring.polynomial()};
}

}  // namespace limes::checker
