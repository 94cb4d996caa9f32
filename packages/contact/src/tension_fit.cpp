#include "tension_fit.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

namespace toile::contact {

namespace {

using Terms = Eigen::Matrix<double, 6, 1>;
using Normal = Eigen::Matrix<double, 6, 6>;

/// Tangents of the plane normal to n.
std::array<Vec3, 2> tangents(const Vec3& n) {
  const Vec3 t = (std::abs(n.x()) < 0.7 ? Vec3::UnitX() : Vec3::UnitY()).cross(n).normalized();
  return {n.cross(t), t};
}

/// t turned back by the least rotation that takes the point's normal to n.
Vec3 turned(const Vec3& t, const Vec3& n, const Vec3& normal) {
  return t - t.dot(normal) / (1.0 + n.dot(normal)) * (n + normal);
}

/// Sums of the least-squares fit of one scalar, tension x curvature, in the tangent plane of a place.
class Fit {
 public:
  Fit(const ContactCluster& place, int degree)
      : place_(place), t_(tangents(place.surface.normal)), terms_(degree == 2 ? 6 : 2 * degree + 1) {
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) curvature_[a][b] = t_[a].dot(place.surface.hessian * t_[b]);
  }
  void add(const TensionPoint& point, Tension which, double inverse_size);
  std::optional<double> value() const;

 private:
  const ContactCluster& place_;
  std::array<Vec3, 2> t_;
  int terms_;
  double curvature_[2][2];
  Normal left_ = Normal::Zero();
  Terms right_ = Terms::Zero();
};

void Fit::add(const TensionPoint& point, Tension which, double inverse_size) {
  const Vec3& n = place_.surface.normal;
  const bool laid = which == Tension::laid && !point.body_normal.isZero();
  Vec3 normal = laid ? point.body_normal : point.normal;
  if (normal.dot(n) < 0.0) normal = -normal;
  const Vec3 s[2] = {turned(t_[0], n, normal), turned(t_[1], n, normal)};
  const Mat3& tension = laid ? point.laid : point.tension;
  double pressure = 0.0;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) pressure += curvature_[a][b] * s[a].dot(tension * s[b]);
  const Vec3 r = inverse_size * (point.position - place_.position);
  const double x = r.dot(t_[0]), y = r.dot(t_[1]);
  Terms basis;
  basis << 1.0, x, y, x * x, x * y, y * y;
  left_ += point.area * basis * basis.transpose();
  right_ += point.area * pressure * basis;
}

std::optional<double> Fit::value() const {
  constexpr double determined = 1e-6;  // smallest over largest eigenvalue; lengths are scaled by the patch's size
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(left_.topLeftCorner(terms_, terms_));
  const Eigen::VectorXd& values = solver.eigenvalues();
  if (!(values[0] > determined * values[terms_ - 1])) return std::nullopt;
  const Eigen::VectorXd first = solver.eigenvectors().row(0).transpose().cwiseQuotient(values);
  return first.dot(solver.eigenvectors().transpose() * right_.head(terms_));
}

}  // namespace

std::optional<double> fitted_pressure(const FabricInContact& fabric, const std::vector<int>& patch,
                                      const ContactCluster& place, Tension tension, int degree) {
  const auto for_points = [&](const auto& use) {
    for (const int e : patch) {
      const FabricElement& element = fabric.elements[static_cast<size_t>(e)];
      for (int q = 0; q < element.points; ++q)
        use(fabric.points[static_cast<size_t>(element.first_point) + static_cast<size_t>(q)]);
    }
  };
  double squares = 0.0, area = 0.0;
  for_points([&](const TensionPoint& p) {
    squares += p.area * (p.position - place.position).squaredNorm();
    area += p.area;
  });
  if (!(squares > 0.0)) return std::nullopt;
  Fit fit(place, degree);
  for_points([&](const TensionPoint& p) { fit.add(p, tension, std::sqrt(area / squares)); });
  return fit.value();
}

}  // namespace toile::contact
