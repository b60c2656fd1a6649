// SPDX-License-Identifier: MIT
//
// A polytope norm in which the difference scheme contracts. On the closed leaf b = B / D with Bernstein coefficients
// B_I, D_I > 0, so b is a convex combination of the B_I / D_I, with weights that do not depend on the entry; so are its
// finite sections, and their diagonal blocks in a block triangular form. A norm of each block in which all M_{I,e} are
// less than 1 therefore makes all products of sections tend to 0: the joint spectral radius of a block triangular
// family is the greatest of those of its diagonal blocks.
#include "proofs/checker/polytope.hpp"

#include <algorithm>

namespace limes::checker {
namespace {

using Rows = std::vector<std::vector<mpq_class>>;

constexpr std::size_t max_size = 64;  // of the sections

/// "1/2 -3 0": what stands between single blanks.
std::vector<std::string_view> words(const Reader& reader, const Json& json, const std::string& what) {
  const std::string_view text = reader.text(json, what);
  std::vector<std::string_view> result;
  for (std::size_t begin = 0; !text.empty() && begin <= text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    result.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return result;
}

mpq_class read_number(std::string_view text, Budget& budget) {
  budget.work(500 + 2. * static_cast<double>(text.size() * text.size()));
  budget.hold(64 + static_cast<double>(text.size()));
  return read_rational(text, "proof");
}

/// Rows of rationals of one length.
Rows read_rows(const Reader& reader, const Json& json, std::size_t length, const std::string& what, Budget& budget) {
  Rows rows;
  for (const Json& row : json) {
    const auto numbers = words(reader, row, what);
    if (numbers.size() != length) reader.fail("needs rows of " + std::to_string(length) + " rationals as " + what);
    rows.emplace_back();
    for (const auto number : numbers) rows.back().push_back(read_number(number, budget));
  }
  return rows;
}

PolytopeWitness::Block read_block(const Json& json, const std::string& where, Budget& budget) {
  const Reader reader(json, "proof", where, {"size", "unit", "vectors", "images"});
  PolytopeWitness::Block block;
  block.size = static_cast<std::size_t>(reader.integer(reader.at("size"), "size", 1, max_size));
  const mpq_class unit = read_number(reader.text(reader.at("unit"), "unit"), budget);
  if (unit <= 0) reader.fail("needs a positive unit");
  const Rows vectors = read_rows(reader, reader.list("vectors", 0, 100000), block.size, "vectors", budget);

  // Only ratios of lengths matter: all are multiplied by one number that makes them integers.
  mpz_class scale = unit.get_den();
  for (const auto& vector : vectors)
    for (const auto& x : vector) {
      budget.work(100 + 2 * limbs(scale) * limbs(x));
      if (limbs(scale = lcm(scale, x.get_den())) > 10000) reader.fail("needs shorter common denominators");
    }
  const auto scaled = [&](const mpq_class& x) {
    budget.work(100 + 2 * limbs(scale) * limbs(x));
    budget.hold(16 + 8 * (limbs(scale) + limbs(x)));
    return mpz_class(x.get_num() * (scale / x.get_den()));
  };
  block.unit = scaled(unit);
  for (const auto& vector : vectors) {
    block.vectors.emplace_back();
    for (const auto& x : vector) block.vectors.back().push_back(scaled(x));
  }

  for (const Json& matrix : reader.list("images", 1, 100000)) {
    if (!matrix.is_array() || matrix.size() != vectors.size() + block.size)
      reader.fail("needs one combination for every vector and every unit vector in each list of images");
    block.images.emplace_back();
    for (const Json& terms : matrix) {
      const auto numbers = words(reader, terms, "a combination");
      if (numbers.size() % 2 != 0) reader.fail("needs an index before every coefficient in images");
      auto& combination = block.images.back().emplace_back();
      budget.hold(64);
      for (std::size_t k = 0; k < numbers.size(); k += 2) {
        const mpq_class index = read_number(numbers[k], budget);
        if (index.get_den() != 1 || index < 0 || index >= vectors.size()) reader.fail("has an index of no vector in images");
        combination.emplace_back(static_cast<int>(index.get_num().get_si()), read_number(numbers[k + 1], budget));
      }
    }
  }
  return block;
}

/// The inverse, by Gauss and Jordan. \throws Rejected when there is none
Rows inverse(Rows a) {
  const std::size_t n = a.size();
  Rows result(n, std::vector<mpq_class>(n));
  for (std::size_t k = 0; k < n; ++k) result[k][k] = 1;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && a[pivot][k] == 0) ++pivot;
    if (pivot == n) throw Rejected{"polytope", "the basis is no basis"};
    std::swap(a[k], a[pivot]);
    std::swap(result[k], result[pivot]);
    const mpq_class factor = 1 / a[k][k];
    for (Rows* rows : {&a, &result})
      for (auto& x : (*rows)[k]) x *= factor;
    for (std::size_t i = 0; i < n; ++i) {
      const mpq_class multiple = a[i][k];
      if (i == k || multiple == 0) continue;
      for (Rows* rows : {&a, &result})
        for (std::size_t j = 0; j < n; ++j) (*rows)[i][j] -= multiple * (*rows)[k][j];
    }
  }
  return result;
}

Rows product(const Rows& x, const Rows& y) {
  Rows result(x.size(), std::vector<mpq_class>(y[0].size()));
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t k = 0; k < y.size(); ++k)
      for (std::size_t j = 0; x[i][k] != 0 && j < y[0].size(); ++j) result[i][j] += x[i][k] * y[k][j];
  return result;
}

std::size_t section_size(const LocalScheme& scheme) {
  const std::size_t width = scheme.quotient.count() - 1, q = static_cast<std::size_t>(scheme.arity - 1);
  return std::max<std::size_t>(1, (width + q - 1) / q);
}

/// (M_{I,e})_{ij} = B_{e + pj - i, I} / D_I. Scaled Bernstein coefficients have one binomial factor for both.
Rows section(const LocalScheme& scheme, std::size_t place, int letter) {
  const Bernstein& b = scheme.quotient;
  const long n = static_cast<long>(section_size(scheme)), count = static_cast<long>(b.count());
  Rows result(static_cast<std::size_t>(n), std::vector<mpq_class>(static_cast<std::size_t>(n)));
  for (long i = 0; i < n; ++i) {
    // The index set is invariant: the entry is 0 for i in it and every j outside of it.
    for (long j = -count - n; j <= count + n; ++j) {
      const long k = letter + scheme.arity * j - i;
      if (k < 0 || k >= count) continue;
      const mpz_class& entry = b.coefficients[static_cast<std::size_t>(k) * b.size() + place];
      if (j >= 0 && j < n) {
        mpq_class& x = result[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
        x = mpq_class(entry, scheme.denominator.coefficients[place]);
        x.canonicalize();
      } else if (entry != 0) {
        throw Rejected{"polytope", "the section is not invariant"};
      }
    }
  }
  return result;
}

/// sum |c_j| + ||M v - sum c_j v_j||_1 / unit < 1 for every vector v and for the unit vectors times `unit`: the norm whose
/// ball is the symmetric hull of all of them has ||M|| < 1.
void prove_contraction(const Rows& matrix, const PolytopeWitness::Block& block, std::size_t index, Budget& budget) {
  const std::size_t n = block.size;
  mpz_class d = 1;
  for (const auto& row : matrix)
    for (const auto& x : row) {
      budget.work(200 + 2 * limbs(d) * limbs(x));
      d = lcm(d, x.get_den());
    }
  double greatest = limbs(d), longest = limbs(block.unit);
  for (const auto& row : matrix)
    for (const auto& x : row) greatest = std::max(greatest, limbs(x) + limbs(d));
  for (const auto& vector : block.vectors)
    for (const auto& x : vector) longest = std::max(longest, limbs(x));
  std::vector<std::vector<mpz_class>> integers(n, std::vector<mpz_class>(n));  // d M
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) integers[i][j] = matrix[i][j].get_num() * (d / matrix[i][j].get_den());

  for (std::size_t v = 0; v < block.vectors.size() + n; ++v) {
    const auto& combination = block.images[index][v];
    mpz_class q = 1, sum = 0, rest = 0, entry;
    double coefficients = 2;
    for (const auto& [j, c] : combination) coefficients += limbs(c);
    const auto terms = static_cast<double>(combination.size()), size = static_cast<double>(n);
    budget.work(terms * (300 + 2 * coefficients * coefficients) +
                size * (size * cost(greatest, longest) + terms * cost(coefficients, longest) +
                        2 * cost(greatest + coefficients, longest + coefficients)));
    for (const auto& [j, c] : combination) q = lcm(q, c.get_den());
    std::vector<mpz_class> multiples;  // q c_j
    for (const auto& [j, c] : combination) {
      multiples.push_back(c.get_num() * (q / c.get_den()));
      sum += abs(multiples.back());
    }
    for (std::size_t i = 0; i < n; ++i) {
      entry = 0;
      if (v < block.vectors.size()) {
        for (std::size_t j = 0; j < n; ++j) entry += integers[i][j] * block.vectors[v][j];
      } else {
        entry = integers[i][v - block.vectors.size()] * block.unit;
      }
      mpz_class combined = 0;
      for (std::size_t k = 0; k < combination.size(); ++k)
        combined += multiples[k] * block.vectors[static_cast<std::size_t>(combination[k].first)][i];
      rest += abs(mpz_class(q * entry - d * combined));
    }
    if (sum * d * block.unit + rest >= q * d * block.unit)
      throw Rejected{"polytope", "image " + std::to_string(v) + " of matrix " + std::to_string(index) +
                                     " is not inside of the polytope"};
  }
}

}  // namespace

PolytopeWitness read_polytope(const Json& json, const std::string& where, Budget& budget) {
  std::vector<std::string> keys{"blocks"};
  if (json.is_object() && json.contains("basis")) keys.emplace_back("basis");
  const Reader reader(json, "proof", where + ": the polytope", keys);
  PolytopeWitness witness;
  for (const Json& block : reader.list("blocks", 1, max_size))
    witness.blocks.push_back(read_block(block, where + ": block " + std::to_string(witness.blocks.size() + 1), budget));
  if (keys.size() == 1) return witness;
  const Json& basis = reader.list("basis", 1, max_size);
  witness.basis = read_rows(reader, basis, basis.size(), "basis", budget);
  return witness;
}

void prove_polytope(const LocalScheme& scheme, const PolytopeWitness& witness, Budget& budget) {
  if (scheme.quotient.count() == 0) return;  // b = 0
  const auto& d = scheme.denominator.coefficients;
  if (std::any_of(d.begin(), d.end(), [](const mpz_class& c) { return c <= 0; }))
    throw Rejected{"denominator", "a polytope needs positive Bernstein coefficients of the denominator"};
  const std::size_t n = section_size(scheme), matrices = d.size() * static_cast<std::size_t>(scheme.arity);
  if (n > max_size) throw Rejected{"limits", "a polytope of more than " + std::to_string(max_size) + " dimensions"};
  std::size_t sum = 0;
  for (const auto& block : witness.blocks) {
    sum += block.size;
    if (block.images.size() != matrices)
      throw Rejected{"polytope", "there are " + std::to_string(matrices) + " matrices, not " +
                                     std::to_string(block.images.size())};
  }
  if (sum != n || (!witness.basis.empty() && witness.basis.size() != n))
    throw Rejected{"polytope", "the blocks do not have the " + std::to_string(n) + " dimensions of the sections"};
  if (witness.basis.empty() && witness.blocks.size() > 1) throw Rejected{"polytope", "blocks need a basis"};

  const auto size = static_cast<double>(n);
  double basis = 0, entry = limbs(scheme.quotient) + limbs(scheme.denominator);
  for (const auto& row : witness.basis)
    for (const auto& x : row) basis += limbs(x);
  // By Cramer's rule numbers of the elimination are about as long as all of the basis together.
  if (basis > 0) budget.work(2 * size * size * size * (1000 + cost(2 * basis, 2 * basis)));
  const Rows back = witness.basis.empty() ? Rows{} : inverse(witness.basis);
  entry += 4 * basis;
  for (std::size_t index = 0; index < matrices; ++index) {
    const auto p = static_cast<std::size_t>(scheme.arity);
    budget.work(size * (size + static_cast<double>(scheme.quotient.count())) * 500);
    if (!back.empty()) budget.work(2 * size * size * size * (1000 + cost(entry, entry)));
    Rows matrix = section(scheme, index / p, static_cast<int>(index % p));
    if (!back.empty()) matrix = product(back, product(matrix, witness.basis));
    std::size_t start = 0;
    for (const auto& block : witness.blocks) {
      Rows diagonal;
      for (std::size_t i = start; i < start + block.size; ++i) {
        for (std::size_t j = 0; j < start; ++j)
          if (matrix[i][j] != 0) throw Rejected{"polytope", "the sections are not block triangular in the basis"};
        diagonal.emplace_back(matrix[i].begin() + static_cast<std::ptrdiff_t>(start),
                              matrix[i].begin() + static_cast<std::ptrdiff_t>(start + block.size));
      }
      prove_contraction(diagonal, block, index, budget);
      start += block.size;
    }
  }
}

}  // namespace limes::checker
