#include "geometry/refine_mesh.hpp"

#include "algebra/error.hpp"
#include "geometry/io/obj.hpp"
#include "geometry/tensor_net.hpp"
#include "schemes/catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace limes {
namespace {

constexpr double pi = std::numbers::pi;

LevelWeights two_angles(AngleType type_0, double theta_0, AngleType type_1, double theta_1) {
  return approx_level_weights(*load_scheme("unified").surface, {EdgeAngle{type_0, Rational(theta_0)}, EdgeAngle{type_1, Rational(theta_1)}}, 8);
}
LevelWeights same_angle(AngleType type, double theta) { return two_angles(type, theta, type, theta); }

PolygonMesh cube() {
  PolygonMesh mesh;
  for (int k = 0; k < 8; ++k) mesh.points.push_back({double(k & 1), double(k >> 1 & 1), double(k >> 2 & 1)});
  mesh.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return mesh;
}

/// f on the grid of m x n vertices.
template <class F>
TensorNet net_of(std::size_t rows, std::size_t columns, const F& f) {
  TensorNet net{rows, columns, {}};
  for (std::size_t m = 0; m < rows; ++m) {
    for (std::size_t n = 0; n < columns; ++n) net.points.push_back(f(double(m), double(n)));
  }
  return net;
}

double norm(const Point3& p) { return std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z); }

TEST(RefineMesh, TorusAsMeshAndAsNetAgreeAndLieOnTheTorus) {
  const double angle = 2 * pi / 8;
  TensorNet net = net_of(8, 8, [&](double m, double n) {
    return Point3{(3 + std::cos(m * angle)) * std::cos(n * angle), (3 + std::cos(m * angle)) * std::sin(n * angle), std::sin(m * angle)};
  });
  net.across_rows = net.across_columns = NetEnds::periodic;
  const LevelWeights weights = same_angle(AngleType::trigonometric, angle);
  const TensorNet fine = refine_net(net, weights, {4});
  const QuadMesh mesh = refine_mesh(quad_mesh(polygon_mesh(net)), weights, {4});
  EXPECT_EQ(mesh.vertices(), fine.points.size());
  for (const auto* points : {&fine.points, &mesh.points()}) {
    for (const Point3& p : *points) EXPECT_NEAR(std::hypot(std::hypot(p.x, p.y) - 3, p.z), 1, 1e-13);
  }
  // The same points: every one of the mesh is one of the net, found by its angles.
  for (const Point3& p : mesh.points()) {
    const auto index = [&](double a) { return std::size_t(std::lround((a < 0 ? a + 2 * pi : a) / (angle / 16))) % 128; };
    const Point3& q = fine.at(index(std::atan2(p.z, std::hypot(p.x, p.y) - 3)), index(std::atan2(p.y, p.x)));
    EXPECT_LT(norm(p - q), 1e-12);
  }
}

TEST(RefineMesh, AffineMapsCommute) {
  const auto map = [](const Point3& p) { return Point3{2 * p.x - p.y + 1, p.y + 3 * p.z, p.x - p.z - 2}; };
  PolygonMesh moved = cube();
  for (Point3& p : moved.points) p = map(p);
  const LevelWeights weights = same_angle(AngleType::hyperbolic, 1);
  const QuadMesh a = refine_mesh(quad_mesh(cube()), weights, {4}), b = refine_mesh(quad_mesh(moved), weights, {4});
  ASSERT_EQ(a.vertices(), b.vertices());
  for (MeshIndex v = 0; v < a.vertices(); ++v) EXPECT_LT(norm(map(a.point(v)) - b.point(v)), 1e-12);
}

TEST(RefineMesh, CubeKeepsItsSymmetriesEulerCharacteristicAndVertices) {
  const QuadMesh mesh = refine_mesh(quad_mesh(cube()), same_angle(AngleType::trigonometric, 0), {5});
  EXPECT_EQ(mesh.vertices() + mesh.faces(), mesh.edges() + 2);
  for (int k = 0; k < 8; ++k) EXPECT_EQ(mesh.point(MeshIndex(k)), cube().points[std::size_t(k)]);
  double least = 2, greatest = -2;
  Point3 sum;
  for (const Point3& p : mesh.points()) {
    least = std::min({least, p.x, p.y, p.z});
    greatest = std::max({greatest, p.x, p.y, p.z});
    sum += p;
  }
  EXPECT_NEAR(least + greatest, 1, 1e-14);
  EXPECT_LT(norm((1. / double(mesh.vertices())) * sum - Point3{0.5, 0.5, 0.5}), 1e-14);
}

// Valence 4: V_i = L_{i+2}; so a disc of valence 4 treated as regular is the tensor product. Here: a plane stays a plane, with
// parametrisation, around every valence.
TEST(RefineMesh, PlanesStayPlanesAtEveryValence) {
  for (int n = 3; n <= 9; ++n) {
    PolygonMesh star;
    star.points.push_back({0, 0, 0});
    for (int i = 0; i < n; ++i) {
      const double a = 2 * pi * i / n, b = 2 * pi * (i + 0.5) / n;
      star.points.push_back({std::cos(a), std::sin(a), 0});
      star.points.push_back({1.5 * std::cos(b), 1.5 * std::sin(b), 0});
    }
    for (int i = 0; i < n; ++i) {
      const auto l = [&](int k) { return MeshIndex(1 + 2 * (k % n)); };
      star.faces.push_back({0, l(i), l(i) + 1, l(i + 1)});
    }
    for (Point3& p : star.points) p.z = 2 * p.x - 3 * p.y + 1;
    const QuadMesh mesh = refine_mesh(quad_mesh(star), same_angle(AngleType::trigonometric, 1), {3});
    for (const Point3& p : mesh.points()) EXPECT_NEAR(p.z, 2 * p.x - 3 * p.y + 1, 1e-13);
  }
}

TEST(RefineMesh, ExactBoundaryReproducesWhatTheLinearOneDoesNot) {
  const double angle = 0.5;
  const TensorNet net = net_of(5, 6, [&](double m, double n) { return Point3{m, std::cos(n * angle), std::sin(n * angle)}; });
  const LevelWeights weights = same_angle(AngleType::trigonometric, angle);
  const auto distance = [&](MeshBoundary boundary) {
    double greatest = 0;
    const QuadMesh fine = refine_mesh(quad_mesh(polygon_mesh(net)), weights, {4, boundary});
    for (const Point3& p : fine.points())
      greatest = std::max(greatest, std::abs(std::hypot(p.y, p.z) - 1));
    return greatest;
  };
  EXPECT_LT(distance(MeshBoundary::exact), 1e-13);
  EXPECT_GT(distance(MeshBoundary::linear), 1e-3);
}

TEST(RefineMesh, CreasesAreCurvesOfTheirOwnVerticesOnly) {
  // A 5 x 5 grid folded along its middle row; the fold is sharp, so each half stays a plane.
  const TensorNet net = net_of(5, 5, [&](double m, double n) { return Point3{m, n, std::abs(m - 2)}; });
  PolygonMesh mesh = polygon_mesh(net);
  const LevelWeights weights = same_angle(AngleType::trigonometric, 0);
  const auto error = [&] {
    double greatest = 0;
    const QuadMesh fine = refine_mesh(quad_mesh(mesh), weights, {3});
    for (const Point3& p : fine.points()) greatest = std::max(greatest, std::abs(p.z - std::abs(p.x - 2)));
    return greatest;
  };
  EXPECT_GT(error(), 0.01);
  for (MeshIndex n = 0; n < 4; ++n) mesh.sharp.emplace_back(10 + n, 11 + n);
  EXPECT_LT(error(), 1e-14);
}

TEST(RefineMesh, TwoAnglesNeedDirections) {
  const LevelWeights weights = two_angles(AngleType::hyperbolic, 0.4, AngleType::trigonometric, 2 * pi / 9);
  // One sheet of a hyperboloid: hyperbolic along, trigonometric around.
  TensorNet net = net_of(6, 9, [](double m, double n) {
    const double u = 0.4 * (m - 2.5), v = 2 * pi * n / 9;
    return Point3{std::cosh(u) * std::cos(v), std::cosh(u) * std::sin(v), std::sinh(u)};
  });
  net.across_columns = NetEnds::periodic;
  const auto off = [](const Point3& p) { return std::abs(p.x * p.x + p.y * p.y - p.z * p.z - 1); };
  const TensorNet fine = refine_net(net, weights, {4, MeshBoundary::exact});
  for (const Point3& p : fine.points) EXPECT_LT(off(p), 1e-12);
  const QuadMesh mesh = refine_mesh(quad_mesh(polygon_mesh(net)), weights, {4, MeshBoundary::exact});
  for (const Point3& p : mesh.points()) EXPECT_LT(off(p), 1e-12);
  EXPECT_THROW(refine_mesh(quad_mesh(cube()), weights, {1}), InputError);
}

TEST(QuadMesh, BadMeshesAreNamed) {
  const auto reason = [](const PolygonMesh& mesh) -> std::string {
    try {
      quad_mesh(mesh);
    } catch (const InputError& error) {
      return error.reason();
    }
    return "";
  };
  PolygonMesh mesh = cube();
  mesh.faces[1] = {6, 7, 5, 4};
  EXPECT_NE(reason(mesh).find("opposite orientations"), std::string::npos) << reason(mesh);
  mesh = cube();
  mesh.faces.push_back({0, 2, 3, 1});
  EXPECT_NE(reason(mesh).find("more than two faces"), std::string::npos) << reason(mesh);
  mesh = cube();
  mesh.faces[2] = {0, 1, 5, 1};
  EXPECT_EQ(reason(mesh), "face 3 has vertex 2 twice");
  mesh = cube();
  mesh.points.push_back({});
  EXPECT_EQ(reason(mesh), "vertex 9 belongs to no face");
  mesh = cube();
  mesh.points[3].y = NAN;
  EXPECT_EQ(reason(mesh), "vertex 4 has a coordinate that is not finite");
  mesh = cube();
  mesh.faces.push_back({0, 8, 9, 10});
  for (double k = 0; k < 3; ++k) mesh.points.push_back({k, k, k});
  EXPECT_EQ(reason(mesh), "the faces at vertex 1 do not form one fan");
  mesh = cube();
  mesh.sharp = {{0, 3}};
  EXPECT_EQ(reason(mesh), "the sharp line of vertices 1 and 4 is no edge");
}

TEST(Obj, IsReadBackBitByBit) {
  PolygonMesh mesh = cube();
  mesh.sharp = {{0, 1}, {1, 3}};
  const QuadMesh fine = refine_mesh(quad_mesh(mesh), same_angle(AngleType::trigonometric, 1), {2});
  const std::string text = to_obj(fine);
  EXPECT_EQ(to_obj(quad_mesh(read_obj(text, "memory"))), text);
  EXPECT_THROW(read_obj("v 1 2\nf 1 1 1\n", "bad.obj"), InputError);
  EXPECT_THROW(read_obj("v 1 2 nan\n", "bad.obj"), InputError);
  EXPECT_THROW(read_obj("v 1 2 3\nf 1 2 3\n", "bad.obj"), InputError);
}

TEST(TensorNet, SphereWithPolesIsASphere) {
  const int half = 7;
  TensorNet net = net_of(half + 1, 2 * half, [&](double m, double n) {
    const double u = pi * m / half, v = pi * n / half;
    const double r = m == 0 || m == half ? 0 : std::sin(u);
    return Point3{r * std::cos(v), r * std::sin(v), std::cos(u)};
  });
  net.across_rows = NetEnds::poles;
  net.across_columns = NetEnds::periodic;
  const TensorNet fine = refine_net(net, same_angle(AngleType::trigonometric, pi / half), {3});
  for (const Point3& p : fine.points) EXPECT_NEAR(norm(p), 1, 1e-13);
  const QuadMesh mesh = quad_mesh(polygon_mesh(fine));
  EXPECT_EQ(mesh.vertices() + mesh.faces(), mesh.edges() + 2);
}

}  // namespace
}  // namespace limes
