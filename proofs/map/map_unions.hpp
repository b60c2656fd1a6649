#pragma once

#include "proofs/map/parameter_map.hpp"

namespace limes {

/// A box on which one verdict holds, with one certificate for all of it, or several for parts that cover it.
struct MapUnion {
  Box region;
  Outcome verdict = Outcome::undecided;
  std::vector<MapCell> parts;
};

/// Neighbours with the same verdict joined to boxes as large as can be (of one parameter: the maximal intervals), undecided ones
/// too. Certificates of parts are joined where the checker accepts the result. \pre the cells of a map, in its order
std::vector<MapUnion> map_unions(const std::vector<MapCell>& cells, const VariableNames& parameters);

}  // namespace limes
