// The JSON form of polytope norms (docs/certificate.md, "Polytope norms"). Included by sources only.
#pragma once

#include "analysis/spectral_radius/moving_polytope.hpp"

#include <nlohmann/json.hpp>

namespace limes {

nlohmann::ordered_json matrix_to_json(const RationalMatrix& a);
/// null for one block.
nlohmann::ordered_json form_to_json(const BlockTriangularForm& form);
/// [[index, re], [index, re, im], ..], with the number of vectors added to the index of a conjugate.
nlohmann::ordered_json combination_to_json(const SparseCombination& combination, std::size_t vectors);
nlohmann::ordered_json polytope_to_json(const Polytope& polytope);
/// {"form", "blocks"}; the bound is not part of it.
nlohmann::ordered_json norm_to_json(const PolytopeNorm& norm);

nlohmann::ordered_json norm_to_json(const MovingNorm& norm);

}  // namespace limes
