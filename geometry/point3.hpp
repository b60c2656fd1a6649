#pragma once

namespace limes {

/// A point or a vector of R^3.
struct Point3 {
  double x = 0, y = 0, z = 0;

  Point3& operator+=(const Point3& q) { return x += q.x, y += q.y, z += q.z, *this; }
  friend Point3 operator+(const Point3& p, const Point3& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }
  friend Point3 operator-(const Point3& p, const Point3& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
  friend Point3 operator*(double s, const Point3& p) { return {s * p.x, s * p.y, s * p.z}; }
  friend bool operator==(const Point3&, const Point3&) = default;
};

}  // namespace limes
