// SPDX-License-Identifier: MIT
//
// Moving polytopes: for B_e(s) = (1-s) B_e(0) + s B_e(1) and vectors v_j(s) = (1-s) v_j(0) + s v_j(1), let P(s) be the hull of all
// z v_j(s), z conj(v_j(s)) and z unit e_k, |z| = 1. With quadratics c_j(s) the remainder r(s) = B_e(s) v_i(s) - sum_j c_j(s) v_j(s) is a
// cubic, and |c_j(s)| at most the quadratic with the Bernstein coefficients |c_j,0|, |c_j,1|, |c_j,2|. If all four Bernstein coefficients of
// sum |c_j| + ||r||_1 / unit, in degree 3, are at most R, then B_e(s) P(s) lies in R P(s) for every s in [0, 1].
#include "proofs/checker/json.hpp"
#include "proofs/checker/polytope.hpp"

#include <array>

namespace limes::checker {
namespace {

using Json = nlohmann::json;

constexpr std::size_t max_vectors = 20000;

struct MovingVector {
  std::array<Vector, 2> ends;
};

void require(bool condition, const std::string& reason) {
  if (!condition) throw Rejected{"polytope", reason};
}

Vector read_vector(const Json& json, std::size_t n, Budget& budget) {
  require(json.is_array() && (json.size() == n || json.size() == 2 * n), "a vector has a wrong length");
  Vector v;
  for (const Json& entry : json) (v.real.size() < n ? v.real : v.imaginary).push_back(read_number(entry, "polytope", "a vector", budget));
  return v;
}

std::array<mpq_class, 3> read_quadratic(const Json& json, const std::string& where, Budget& budget) {
  require(json.is_array() && json.size() == 3, where + ": a coefficient is a list of three numbers");
  return {read_number(json[0], "polytope", where, budget), read_number(json[1], "polytope", where, budget),
          read_number(json[2], "polytope", where, budget)};
}

/// x += factor y.
void add_multiple(Vector& x, unsigned factor, const Vector& y, Budget& budget) {
  const mpq_class c = factor;
  for (std::size_t i = 0; i < y.real.size(); ++i) add_product(x.real[i], c, y.real[i], budget);
  for (std::size_t i = 0; i < y.imaginary.size(); ++i) add_product(x.imaginary[i], c, y.imaginary[i], budget);
}

/// The factor of the product of the Bernstein coefficients number k of a quadratic and number l of an affine function, as a part of 3 times the
/// coefficient number k + l in degree 3.
unsigned weight(std::size_t k, std::size_t l) { return k == 1 ? 2 : k == 2 * l ? 3 : 1; }

class MovingPolytope {
 public:
  MovingPolytope(const std::vector<RationalMatrix>& ends, const mpq_class& bound, const Json& json, Budget& budget)
      : ends_(ends), bound_(bound), reader_(json, "polytope", "a moving polytope", {"vectors", "unit", "images"}), budget_(budget) {
    unit_ = read_number(reader_.at("unit"), "polytope", "the unit", budget);
    require(unit_ > 0, "the unit is not positive");
    const std::size_t n = ends.at(0).rows;
    for (const Json& vector : reader_.list("vectors", 0, max_vectors)) {
      require(vector.is_array() && vector.size() == 2, "a moving vector is a list of two vectors");
      vectors_.push_back({{read_vector(vector[0], n, budget), read_vector(vector[1], n, budget)}});
    }
  }

  void prove() {
    const std::size_t letters = ends_.size() / 2, n = ends_[0].rows, count = vectors_.size();
    const Json& images = reader_.list("images", letters, letters);
    for (std::size_t e = 0; e < letters; ++e) {
      require(images[e].is_array() && images[e].size() == count + n, "the images of a matrix have a wrong number");
      for (std::size_t i = 0; i < count + n; ++i) {
        Vector unit{std::vector<mpq_class>(n), {}};
        if (i >= count) unit.real[i - count] = unit_;
        const MovingVector x = i < count ? vectors_[i] : MovingVector{{unit, unit}};
        prove_inside({&ends_[e], &ends_[letters + e]}, x, images[e][i], "matrix " + std::to_string(e) + ", vector " + std::to_string(i));
      }
    }
  }

 private:
  void prove_inside(const std::array<const RationalMatrix*, 2>& b, const MovingVector& x, const Json& terms, const std::string& where) {
    const std::size_t n = b[0]->rows, count = vectors_.size();
    require(terms.is_array() && terms.size() <= 2 * count, where + ": needs a list of terms");
    // 3 times the Bernstein coefficients in degree 3 of B x, then of the remainder: B x has those of a product of affine functions, the middle one
    // in halves, raised by one degree.
    std::array<Vector, 4> rest;
    for (auto& r : rest) r = {std::vector<mpq_class>(n), std::vector<mpq_class>(n)};
    for (std::size_t k : {0, 1}) {
      for (std::size_t l : {0, 1}) {
        const Vector image = product(*b[k], x.ends[l], budget_);
        if (k == l) add_multiple(rest[3 * k], 3, image, budget_);
        if (k == 0 || l == 0) add_multiple(rest[1], 1, image, budget_);
        if (k == 1 || l == 1) add_multiple(rest[2], 1, image, budget_);
      }
    }
    std::array<mpq_class, 3> sums;
    const mpq_class one = 1;
    for (const Json& term : terms) {
      require(term.is_array() && term.size() >= 2 && term.size() <= 3 && term[0].is_number_unsigned(),
              where + ": a term is [index, [numbers]] or [index, [numbers], [numbers]]");
      const std::uint64_t index = term[0].get<std::uint64_t>();
      require(index < 2 * count, where + ": a term has an index that is too large");
      const std::array<mpq_class, 3> re = read_quadratic(term[1], where, budget_);
      const std::array<mpq_class, 3> im = term.size() == 3 ? read_quadratic(term[2], where, budget_) : std::array<mpq_class, 3>{};
      for (std::size_t k = 0; k < 3; ++k) {
        add_product(sums[k], one, modulus(re[k], im[k], budget_), budget_);
        for (std::size_t l : {0, 1}) {
          const mpq_class factor = weight(k, l);
          budget_.work(200 + 4 * (limbs(re[k]) + limbs(im[k])));
          subtract(rest[k + l], factor * re[k], factor * im[k], vectors_[index % count].ends[l], index >= count, budget_);
        }
      }
    }
    const std::array<mpq_class, 4> norms{3 * sums[0], sums[0] + 2 * sums[1], 2 * sums[1] + sums[2], 3 * sums[2]};
    for (std::size_t k = 0; k < 4; ++k) {
      mpq_class size = 0;
      for (const auto* part : {&rest[k].real, &rest[k].imaginary})
        for (const mpq_class& entry : *part) add_product(size, one, abs(entry), budget_);
      budget_.work(2000 + 20 * (limbs(size) + limbs(norms[k])) * (limbs(unit_) + limbs(bound_)));
      if (norms[k] + size / unit_ > 3 * bound_) throw Rejected{"polytope", where + ": the image is longer than the bound"};
    }
  }

  const std::vector<RationalMatrix>& ends_;
  const mpq_class& bound_;
  const Reader reader_;
  Budget& budget_;
  mpq_class unit_;
  std::vector<MovingVector> vectors_;
};

}  // namespace

void prove_moving_norm(const std::vector<RationalMatrix>& ends, const mpq_class& bound, const Json& norm, Budget& budget) {
  const Reader reader(norm, "polytope", "the norm", {"form", "blocks"});
  require(!ends.empty() && ends.size() % 2 == 0, "a moving polytope needs matrices in pairs");
  const Blocks blocks = diagonal_blocks(ends, reader.at("form"), budget);
  const Json& polytopes = reader.list("blocks", blocks.families.size(), blocks.families.size());
  for (std::size_t k = 0; k < blocks.families.size(); ++k) MovingPolytope(blocks.families[k], bound, polytopes[k], budget).prove();
}

}  // namespace limes::checker
