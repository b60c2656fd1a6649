// SPDX-License-Identifier: MIT
#include "proofs/checker/bernstein.hpp"

#include <algorithm>
#include <set>

namespace limes::checker {

Bernstein Bernstein::polynomial(std::size_t j) const {
  const auto start = coefficients.begin() + static_cast<std::ptrdiff_t>(j * size());
  return {degrees, std::vector<mpz_class>(start, start + static_cast<std::ptrdiff_t>(size()))};
}

bool Bernstein::is_zero(std::size_t j) const {
  const auto start = coefficients.begin() + static_cast<std::ptrdiff_t>(j * size());
  return std::all_of(start, start + static_cast<std::ptrdiff_t>(size()), [](const mpz_class& c) { return c == 0; });
}

double tensor_size(const std::vector<int>& degrees, double multiple) {
  double result = 1;
  for (const int n : degrees) result *= multiple * n + 1;
  return result;
}

double limbs(const Bernstein& p) {
  double result = 1;
  for (const auto& c : p.coefficients) result = std::max(result, limbs(c));
  return result;
}

Bernstein to_bernstein(const std::vector<Polynomial>& polynomials, const Region& box,
                       const std::vector<std::size_t>& axes, const std::vector<int>& degrees, Budget& budget) {
  double size = 2, tables = 0, terms = 0;
  // x = (a s + b t) / g along axis k, so g^n x^e = (a s + b t)^e (g s + g t)^{n-e}; this is monomials[k][e].
  std::vector<std::vector<Bernstein>> monomials(axes.size());
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const mpq_class &lower = box[axes[k]].lower.value, &upper = box[axes[k]].upper.value;
    const mpz_class g = lcm(lower.get_den(), upper.get_den());
    const mpz_class a = mpq_class(lower * g).get_num(), b = mpq_class(upper * g).get_num();
    const mpz_class largest = abs(a) + abs(b) + g;
    const double n = degrees[k] + 1, bits = static_cast<double>(mpz_sizeinbase(largest.get_mpz_t(), 2)) + 1;
    const double length = n * bits / 64 + 1;
    budget.work(n * n * n * cost(length, length));
    budget.hold(n * n * (32 + 8 * length));
    std::vector<int> unit(axes.size(), 0);
    unit[k] = 1;
    for (int e = 0; e <= degrees[k]; ++e)
      monomials[k].push_back(convolve(power({unit, {a, b}}, e), power({unit, {g, g}}, degrees[k] - e)));
    tables += length;
  }
  mpz_class denominator = 1;
  for (const auto& polynomial : polynomials) {
    for (const auto& [exponents, c] : polynomial) {
      size = std::max(size, limbs(c));
      budget.work(100 + 4 * size * limbs(denominator));
      denominator = lcm(denominator, c.get_den());
      ++terms;
    }
  }
  const double entries = tensor_size(degrees, 1), length = size + tables + limbs(denominator);
  budget.work((500 + entries * 2 * cost(length, length)) * (terms * (1. + static_cast<double>(axes.size())) + 1));
  budget.hold(static_cast<double>(polynomials.size() + 2) * entries * (32 + 8 * length));

  Bernstein result{degrees, {}};
  const std::size_t stride = result.size();
  result.coefficients.resize(polynomials.size() * stride);
  for (std::size_t j = 0; j < polynomials.size(); ++j) {
    for (const auto& [exponents, c] : polynomials[j]) {
      Bernstein term{std::vector<int>(axes.size(), 0), {mpq_class(c * denominator).get_num()}};
      for (std::size_t k = 0; k < axes.size(); ++k) term = convolve(monomials[k][exponents[axes[k]]], term);
      for (std::size_t i = 0; i < stride; ++i) result.coefficients[j * stride + i] += term.coefficients[i];
    }
  }
  return result;
}

Bernstein convolve(const Bernstein& p, const Bernstein& q, std::size_t spacing) {
  Bernstein result{p.degrees, {}};
  std::vector<std::size_t> p_places{0}, q_places{0};  // of p's and q's multi-indices in the result's shape
  for (std::size_t k = 0; k < p.degrees.size(); ++k) {
    result.degrees[k] += q.degrees[k];
    for (auto [places, degree] : {std::pair{&p_places, p.degrees[k]}, std::pair{&q_places, q.degrees[k]}}) {
      std::vector<std::size_t> next;
      for (const std::size_t place : *places)
        for (int i = 0; i <= degree; ++i)
          next.push_back(place * static_cast<std::size_t>(result.degrees[k] + 1) + static_cast<std::size_t>(i));
      *places = std::move(next);
    }
  }
  const std::size_t size = result.size(), p_count = p.count(), q_count = q.count();
  if (p_count == 0 || q_count == 0) return result;
  result.coefficients.resize((p_count + spacing * (q_count - 1)) * size);
  for (std::size_t i = 0; i < q_count; ++i) {
    for (std::size_t j = 0; j < p_count; ++j) {
      mpz_class* const target = &result.coefficients[(j + spacing * i) * size];
      for (std::size_t a = 0; a < p_places.size(); ++a) {
        const mpz_class& x = p.coefficients[j * p_places.size() + a];
        const mpz_class* const y = &q.coefficients[i * q_places.size()];
        for (std::size_t b = 0; x != 0 && b < q_places.size(); ++b)
          mpz_addmul(target[p_places[a] + q_places[b]].get_mpz_t(), y[b].get_mpz_t(), x.get_mpz_t());
      }
    }
  }
  return result;
}

Bernstein power(const Bernstein& p, int n) {
  Bernstein result{std::vector<int>(p.degrees.size(), 0), {1}};
  for (int k = 0; k < n; ++k) result = convolve(p, result);
  return result;
}

bool is_positive(const std::vector<mpz_class>& coefficients, const std::vector<int>& degrees, const Region& box) {
  const std::size_t axes = degrees.size();
  std::size_t needed = 1;  // smallest faces
  for (std::size_t k = 0; k < axes; ++k)
    if (degrees[k] > 0 && !box[k].lower.after && box[k].upper.after) needed *= 2;
  std::vector<int> index(axes, 0);
  std::set<std::vector<bool>> found;  // for the axes with closed ends: whether it is the lower one
  for (const auto& c : coefficients) {
    if (c < 0) return false;
    std::vector<bool> face;
    bool on_face = c > 0;
    for (std::size_t k = 0; k < axes && on_face; ++k) {
      const bool lower_closed = !box[k].lower.after, upper_closed = box[k].upper.after;
      if (degrees[k] == 0 || (!lower_closed && !upper_closed)) continue;
      face.push_back(lower_closed && index[k] == 0);
      on_face = face.back() || (upper_closed && index[k] == degrees[k]);
    }
    if (on_face) found.insert(std::move(face));
    for (std::size_t k = axes; k-- > 0 && ++index[k] > degrees[k];) index[k] = 0;  // the next index; at the end 0
  }
  return found.size() == needed;
}

}  // namespace limes::checker
