#include "proofs/spectral_radius/norm_json_impl.hpp"

namespace limes {

using Json = nlohmann::ordered_json;

Json matrix_to_json(const RationalMatrix& a) {
  Json rows = Json::array();
  for (int i = 0; i < a.rows(); ++i) {
    Json row = Json::array();
    for (int j = 0; j < a.columns(); ++j) row.push_back(to_string(a(i, j)));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json form_to_json(const BlockTriangularForm& form) {
  if (form.sizes.size() == 1 && form.basis == RationalMatrix::identity(form.sizes.front())) return nullptr;
  return {{"basis", matrix_to_json(form.basis)}, {"inverse", matrix_to_json(form.inverse)}, {"sizes", form.sizes}};
}

Json combination_to_json(const SparseCombination& combination, std::size_t vectors) {
  Json terms = Json::array();
  for (const HullTerm& term : combination) {
    terms.push_back(Json::array({std::size_t(term.index) + (term.conjugate ? vectors : 0), to_string(term.re)}));
    if (term.im != 0) terms.back().push_back(to_string(term.im));
  }
  return terms;
}

namespace {

template <class Numbers>
Json numbers_to_json(const Numbers& numbers) {
  Json entries = Json::array();
  for (const Rational& x : numbers) entries.push_back(to_string(x));
  return entries;
}

/// [[index, [re_0, re_1, re_2]], [index, [..], [im_0, im_1, im_2]], ..]
Json combination_to_json(const MovingCombination& combination, std::size_t vectors) {
  Json terms = Json::array();
  for (const MovingTerm& term : combination) {
    terms.push_back(Json::array({std::size_t(term.index) + (term.conjugate ? vectors : 0), numbers_to_json(term.re)}));
    if (term.im != std::array<Rational, 3>{}) terms.back().push_back(numbers_to_json(term.im));
  }
  return terms;
}

Json moving_polytope_to_json(const MovingPolytope& polytope) {
  Json vectors = Json::array(), images = Json::array();
  for (const auto& v : polytope.vectors) vectors.push_back(Json::array({numbers_to_json(v[0]), numbers_to_json(v[1])}));
  for (const auto& of_matrix : polytope.images) {
    Json combinations = Json::array();
    for (const MovingCombination& combination : of_matrix)
      combinations.push_back(combination_to_json(combination, polytope.vectors.size()));
    images.push_back(std::move(combinations));
  }
  return {{"vectors", std::move(vectors)}, {"unit", to_string(polytope.unit)}, {"images", std::move(images)}};
}

}  // namespace

Json polytope_to_json(const Polytope& polytope) {
  Json vectors = Json::array(), images = Json::array();
  for (const auto& v : polytope.vectors) vectors.push_back(numbers_to_json(v));
  for (const auto& of_matrix : polytope.images) {
    Json combinations = Json::array();
    for (const SparseCombination& combination : of_matrix)
      combinations.push_back(combination_to_json(combination, polytope.vectors.size()));
    images.push_back(std::move(combinations));
  }
  return {{"vectors", std::move(vectors)}, {"unit", to_string(polytope.unit)}, {"images", std::move(images)}};
}

Json norm_to_json(const PolytopeNorm& norm) {
  Json blocks = Json::array();
  for (const Polytope& polytope : norm.blocks) blocks.push_back(polytope_to_json(polytope));
  return {{"form", form_to_json(norm.form)}, {"blocks", std::move(blocks)}};
}

Json norm_to_json(const MovingNorm& norm) {
  Json blocks = Json::array();
  for (const MovingPolytope& polytope : norm.blocks) blocks.push_back(moving_polytope_to_json(polytope));
  return {{"form", form_to_json(norm.form)}, {"blocks", std::move(blocks)}};
}

}  // namespace limes
