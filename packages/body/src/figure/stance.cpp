#include "figure/stance.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <sstream>

#include "toile/base/error.hpp"

namespace toile::body {
namespace {

/// Second moments xx - yy and 2 xy of the area inside a curve about its centroid, mm^4: the long axis lies at half the
/// angle of this vector.
Eigen::Vector2d elongation(const SectionPiece& piece) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double twice_area = 0.0;
  for (std::size_t i = 0; i < piece.points.size(); ++i) {
    const Vec3 a = piece.points[i] - piece.centre, b = piece.points[(i + 1) % piece.points.size()] - piece.centre;
    const double cross = a.x() * b.y() - b.x() * a.y();
    twice_area += cross;
    sum[0] +=
        cross * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x() - a.y() * a.y() - a.y() * b.y() - b.y() * b.y()) / 12.0;
    sum[1] += cross * (a.x() * b.y() + 2.0 * a.x() * a.y() + 2.0 * b.x() * b.y() + b.x() * a.y()) / 12.0;
  }
  return twice_area < 0.0 ? Eigen::Vector2d(-sum) : sum;
}

[[noreturn]] void refuse(const std::string& found, const std::string& remedy) {
  throw base::InputError(found + "; landmarks are found on a body that looks towards -y, with z up: " + remedy);
}

void refuse_lying(const FigureScan& scan) {
  const Vec3 size = scan.extent().upper - scan.extent().lower;
  if (size.head<2>().maxCoeff() > 1.2 * size.z()) {
    const char* axis = size.x() > size.y() ? "x" : "y";
    std::ostringstream found;
    found.precision(4);
    found << "the body is longer along " << axis << " (" << size.head<2>().maxCoeff() << " mm) than it is high ("
          << size.z() << " mm), as if it lay";
    refuse(found.str(), std::string("its height is perhaps along ") + axis + " of the file (up = " + axis + ")");
  }
}

}  // namespace

std::optional<double> heading(const FigureScan& scan) {
  constexpr double round = 0.1;  // a trunk whose elongation is less has no long axis
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double area = 0.0;
  for (const FigureLevel& level : scan.levels()) {
    const double height = (level.z - scan.bottom()) / scan.height();
    const SectionPiece* trunk = level.trunk_piece();
    if (trunk == nullptr || height < 0.4 || height > 0.7) continue;
    sum += elongation(*trunk) / trunk->area;  // every height counts by its size, not by its square
    area += trunk->area;
  }
  // Of an ellipse with half axes a and b the elongation over the area is (a^2 - b^2) / 4.
  if (sum.norm() * 4.0 * M_PI < round * area) return std::nullopt;
  const double angle = 0.5 * std::atan2(sum[1], sum[0]);
  if (std::abs(angle) > 0.25 * M_PI) {
    refuse_lying(scan);
    refuse("the trunk of the body is wider along y than along x, as if it looked sideways", "turn it about z");
  }
  return angle;
}

Vec3 turned_about_z(const Vec3& point, double angle) {
  return Eigen::AngleAxisd(angle, Vec3::UnitZ()) * point;
}

TriangleMesh turned_about_z(const TriangleMesh& mesh, double angle) {
  TriangleMesh turned = mesh;
  for (Vec3& vertex : turned.vertices) vertex = turned_about_z(vertex, angle);
  return turned;
}

void check_upright(const TriangleMesh& mesh, const FigureScan& scan) {
  refuse_lying(scan);
  TriangleMesh over = mesh;
  for (Vec3& vertex : over.vertices) vertex = Vec3(vertex.x(), -vertex.y(), -vertex.z());
  const FigureScan scan_over(over);
  Landmarks found;
  find_crotch_and_armpits({scan_over, &found});
  if (found.find("crotch") != nullptr && found.find("left armpit") != nullptr && found.find("right armpit") != nullptr)
    refuse("the body stands on its head", "turn it over about x");
}

}  // namespace toile::body
