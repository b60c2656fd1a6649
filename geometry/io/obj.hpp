#pragma once

#include "geometry/quad_mesh.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace limes {

/// Reads a Wavefront OBJ file: `v x y z`, faces `f` of any size (a/b/c: only the vertex counts; negative indices count back from the
/// last vertex), and lines `l a b c ..`, whose edges are sharp. Other statements are skipped.
/// \throws InputError "file:line: reason"; LimitError above 1 GiB
PolygonMesh read_obj_file(const std::filesystem::path& file);
/// The same from a text; `file` only names it in messages.
PolygonMesh read_obj(std::string_view text, const std::filesystem::path& file);

/// Vertices, faces and sharp edges, numbers in the shortest decimals that are read back bit by bit.
std::string to_obj(const QuadMesh& mesh);
std::string to_obj(const PolygonMesh& mesh);

}  // namespace limes
