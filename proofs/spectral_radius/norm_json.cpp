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
  if (form.sizes.size() == 1) return nullptr;
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

Json polytope_to_json(const Polytope& polytope) {
  Json vectors = Json::array(), images = Json::array();
  for (const auto& v : polytope.vectors) {
    Json entries = Json::array();
    for (const Rational& x : v) entries.push_back(to_string(x));
    vectors.push_back(std::move(entries));
  }
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

}  // namespace limes
