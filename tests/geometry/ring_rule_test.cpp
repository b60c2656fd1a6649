// The rules around an extraordinary vertex, as analysis takes them, are what refining does to a mesh.
#include "geometry/refine_mesh.hpp"
#include "schemes/catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace limes {
namespace {

constexpr int rings = 4;

/// A mesh around one vertex of valence n, with points at random; point (a, b) of sector s has the index returned by `vertex`.
struct Star {
  int n;
  PolygonMesh mesh;

  MeshIndex vertex(int s, int a, int b) const {
    if (a == 0 && b == 0) return 0;
    if (a == 0) return vertex(s + 1, b, 0);
    return MeshIndex(1 + ((s % n + n) % n) * rings * (rings + 1) + (a - 1) * (rings + 1) + b);
  }

  explicit Star(int valence) : n(valence) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    for (int k = 0; k < 1 + n * rings * (rings + 1); ++k) mesh.points.push_back({coordinate(random), coordinate(random), coordinate(random)});
    for (int s = 0; s < n; ++s) {
      for (int a = 0; a < rings; ++a) {
        for (int b = 0; b < rings; ++b)
          mesh.faces.push_back({vertex(s, a, b), vertex(s, a + 1, b), vertex(s, a + 1, b + 1), vertex(s, a, b + 1)});
      }
    }
  }
};

/// New point (a, b) of sector 0 in the refined mesh: face 4 f + k of that has the corners (old k, edge k, face, edge k - 1).
Point3 refined_point(const QuadMesh& refined, int a, int b) {
  const MeshIndex face = MeshIndex(std::min(a / 2, rings - 1) * rings + std::min(b / 2, rings - 1));
  const int x = a - 2 * std::min(a / 2, rings - 1), y = b - 2 * std::min(b / 2, rings - 1);  // 0, 1, 2
  const int corner = x < 2 ? (y < 2 ? 0 : 3) : (y < 2 ? 1 : 2);
  const bool odd_x = x == 1, odd_y = y == 1;
  // edges of a face: 0 from (0,0) to (1,0), 1 to (1,1), 2 to (0,1), 3 back
  if (odd_x && odd_y) return refined.point(refined.corners()[4 * (4 * face) + 2]);
  const auto edge = [&](MeshIndex k) { return refined.point(refined.corners()[4 * (4 * face + k) + 1]); };
  if (odd_x) return edge(y == 0 ? 0 : 2);
  if (odd_y) return edge(x == 0 ? 3 : 1);
  return refined.point(refined.corners()[4 * (4 * face + MeshIndex(corner))]);
}

TEST(RingRule, VirtualPointsAreThoseOfRefinedMeshes) {
  const SurfaceRule surface = *load_scheme("unified").surface;
  for (const double theta : {0., 0.9}) {
    const EdgeAngle angle{AngleType::trigonometric, Rational(theta)};
    const Rational mu(std::cos(theta / 2));
    const LevelWeights weights = approx_level_weights(surface, {angle, angle}, 1);
    const RingRule rule = virtual_point_rule(surface.sequence.mask);
    for (const int n : {3, 4, 5, 7}) {
      const Star star(n);
      MeshRefinement refinement{1};
      const QuadMesh refined = refine_mesh(quad_mesh(star.mesh), weights, refinement);
      std::vector<RingPoint> points = sector_points(false, 5);
      points.push_back({0, 0});
      for (const RingPoint& point : points) {
        Point3 sum;
        for (const RingTerm& t : rule.at(point)) {
          const double weight = approx_double(t.weight(std::vector<Rational>{mu, n}));
          const auto old = [&](int s) { return star.mesh.points[star.vertex(s, t.point.a, t.point.b)]; };
          if (t.harmonic < 0) {
            sum += weight * old(t.sector);
          } else {
            for (int s = 0; s < n; ++s) sum += weight / n * std::cos(2 * M_PI * t.harmonic * s / n) * old(s);
          }
        }
        const Point3 expected = refined_point(refined, point.a, point.b);
        EXPECT_LT(std::hypot(sum.x - expected.x, sum.y - expected.y, sum.z - expected.z), 1e-12)
            << "n = " << n << ", point " << point.a << "," << point.b;
      }
    }
  }
}

}  // namespace
}  // namespace limes
