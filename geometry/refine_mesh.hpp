#pragma once

#include "algebra/stop.hpp"
#include "geometry/quad_mesh.hpp"
#include "schemes/surface/surface_rule.hpp"

#include <array>
#include <functional>

namespace limes {

/// The weights (outer, inner, inner, outer) of one level of a four-point rule.
struct FourPointWeights {
  double outer = 0, inner = 0;
  /// Cosine, or hyperbolic cosine, of the angle of one edge before the level.
  double edge_cosine = 1;

  /// Of the virtual points at extraordinary vertices.
  double kappa() const { return -outer / inner; }
};

/// The angle of an edge of the control mesh. [0 means the polynomial case]
struct EdgeAngle {
  AngleType type = AngleType::trigonometric;
  Rational theta;
};

/// The weights that make level `level` + 1, for edges of direction 0 and of direction 1 (see below).
using LevelWeights = std::function<std::array<FourPointWeights, 2>(int level)>;

/// The weights of levels 0 .. levels - 1 for one angle in each direction. \throws DomainError at a pole
LevelWeights approx_level_weights(const SurfaceRule& rule, const std::array<EdgeAngle, 2>& angles, int levels);

/// How a mesh continues beyond its boundary, and a crease beyond its sharp edges: q_{-1} = 2 q_0 - q_1 (linear), or
/// q_{-1} = (2+2c) q_0 - (2+4c) q_1 + (2+2c) q_2 - q_3 with the cosine c of an edge's angle, where these points exist (exact):
/// reproduces what the scheme reproduces.
enum class MeshBoundary { linear, exact };

struct MeshRefinement {
  int levels = 1;
  MeshBoundary boundary = MeshBoundary::linear;
  /// More vertices than this in the result are a LimitError, before any work.
  std::size_t max_vertices = std::size_t{1} << 26;
};

/// The surface after some levels of the unified scheme; old vertices stay. New points:
/// - on an edge P, L: outer (H + V) + inner (P + L), where H continues the line P, L beyond L through a vertex of valence 4, and V
///   beyond P likewise. At an extraordinary vertex of valence n the line is continued by a virtual point, for the spoke L_i
///     V_i = (4/n) sum L - (L_{i-1} + L_i + L_{i+1}) + kappa (K_{i-2} + K_{i-1} + K_i + K_{i+1} - (4/n) sum K),
///   L the neighbours and K_i the diagonal vertex of the face between L_i and L_{i+1}; on an edge between two such vertices at both ends.
/// - on boundary and sharp edges: the curve rule along the boundary or crease; at corners (valence 2), and where other than two
///   of these edges meet, the line is continued as at the end of an open polygon.
/// - in a face: the four-point rule across the face on four edge points in a row, in the direction in which none of them lies at an
///   extraordinary vertex off the face; the mean of both directions where neither
///   is so, or where both are and the face has an extraordinary vertex.
/// With different weights for the two directions, direction 0 is that of the first edge of face 1, and the mesh must have
/// directions: opposite edges of a face agree. [Kobbelt 1996; Bari, Mustafa, Ghaffar, Nisar & Baleanu 2021, with corrections]
/// \throws InputError that names a face where directions contradict each other, or an extraordinary vertex when the directions have different
/// weights; LimitError; Interrupted
QuadMesh refine_mesh(QuadMesh mesh, const LevelWeights& weights, const MeshRefinement& refinement, const Stop& stop = Stop());

}  // namespace limes
