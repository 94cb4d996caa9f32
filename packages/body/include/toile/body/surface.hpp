#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <string>
#include <vector>

namespace toile::body {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// Signed distance to the body at one point, from one smooth function: normal = grad gap.
struct SurfacePoint {
  double gap = 0.0;             ///< mm, positive outside
  Vec3 normal = Vec3::Zero();   ///< outward unit normal at the closest point, = gradient of the gap
  Mat3 hessian = Mat3::Zero();  ///< second derivative of the gap, 1/mm
  Vec3 closest = Vec3::Zero();  ///< closest point on the smooth surface, mm
  bool found = false;           ///< false: the point is out of range (see Surface::range)
};

/// How far the surface may be from the body, of which only points are known: what it would change by if it were
/// smoothed more. Differences that pass through zero: their mean square over some area tells the size of the error.
struct SurfaceDoubt {
  double gap = 0.0;             ///< mm
  Mat3 hessian = Mat3::Zero();  ///< 1/mm
};

/// Triangles, for output and for import.
struct TriangleMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from outside
};

/// The rigid body's smooth surface. Thread-safe queries.
class Surface {
 public:
  virtual ~Surface() = default;
  /// Closest point and derivatives. Points further than range() may be answered with found = false and a gap that is a
  /// lower bound of the distance.
  virtual SurfacePoint closest(const Vec3& point) const = 0;
  /// At the closest point of the surface; nothing where there is none, and of a body that is known exactly.
  virtual SurfaceDoubt doubt(const Vec3&) const { return {}; }
  virtual double range() const = 0;
  /// Triangles that show the surface (results, pictures). `size`: wanted edge length, mm; imported bodies return their
  /// own triangles.
  virtual TriangleMesh triangles(double size) const = 0;
  /// One line for the run's summary: kind, size, quality figures.
  virtual std::string summary() const = 0;
};

}  // namespace toile::body
