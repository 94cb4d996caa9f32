#include "tension_fit.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

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

/// Tension x curvature at a place, of the tension at a point nearby or of a mean.
struct Sample {
  Vec3 position = Vec3::Zero();  ///< mm
  double pressure = 0.0;         ///< MPa
  double area = 0.0;             ///< mm^2
  void add(const Sample& other) {
    const double part = other.area / (area + other.area);
    position += part * (other.position - position);
    pressure += part * (other.pressure - pressure);
    area += other.area;
  }
};

/// Sums of the least-squares fit of one scalar, tension x curvature, in the tangent plane of a place.
class Fit {
 public:
  Fit(const ContactCluster& place, int degree)
      : place_(place), t_(tangents(place.surface.normal)), terms_(degree == 2 ? 6 : 2 * degree + 1) {
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) curvature_[a][b] = t_[a].dot(place.surface.hessian * t_[b]);
  }
  double pressure(const TensionPoint& point, Tension which) const;
  void add(const Sample& sample, double inverse_size);
  std::optional<double> value() const;

 private:
  const ContactCluster& place_;
  std::array<Vec3, 2> t_;
  int terms_;
  double curvature_[2][2];
  Normal left_ = Normal::Zero();
  Terms right_ = Terms::Zero();
};

double Fit::pressure(const TensionPoint& point, Tension which) const {
  const Vec3& n = place_.surface.normal;
  const bool laid = which == Tension::laid && !point.body_normal.isZero();
  Vec3 normal = laid ? point.body_normal : point.normal;
  if (normal.dot(n) < 0.0) normal = -normal;
  const Vec3 s[2] = {turned(t_[0], n, normal), turned(t_[1], n, normal)};
  const Mat3& tension = laid ? point.laid : point.tension;
  double pressure = 0.0;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) pressure += curvature_[a][b] * s[a].dot(tension * s[b]);
  return pressure;
}

void Fit::add(const Sample& sample, double inverse_size) {
  const Vec3 r = inverse_size * (sample.position - place_.position);
  const double x = r.dot(t_[0]), y = r.dot(t_[1]);
  Terms basis;
  basis << 1.0, x, y, x * x, x * y, y * y;
  left_ += sample.area * basis * basis.transpose();
  right_ += sample.area * sample.pressure * basis;
}

std::optional<double> Fit::value() const {
  constexpr double determined = 1e-6;  // smallest over largest eigenvalue; lengths are scaled by the patch's size
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(left_.topLeftCorner(terms_, terms_));
  const Eigen::VectorXd& values = solver.eigenvalues();
  if (!(values[0] > determined * values[terms_ - 1])) return std::nullopt;
  const Eigen::VectorXd first = solver.eigenvectors().row(0).transpose().cwiseQuotient(values);
  return first.dot(solver.eigenvectors().transpose() * right_.head(terms_));
}

/// What a fit is made of. The tension of linear shape functions has an error of first order that changes its sign
/// within a quadrilateral, and from a triangle to the next; their means have not. A sum over points would do where
/// elements lie all around; at an edge the sign would tilt the fit.
class Samples {
 public:
  Samples(const FabricInContact& fabric, const std::vector<int>& patch, const Fit& fit, Tension tension);
  const std::vector<Sample>& all() const { return all_; }

 private:
  struct Side {
    std::pair<int, int> sites;
    size_t triangle;
  };
  void pair_triangles(std::vector<Side> sides);

  std::vector<Sample> all_, triangles_;
};

Samples::Samples(const FabricInContact& fabric, const std::vector<int>& patch, const Fit& fit, Tension tension) {
  std::vector<Side> sides;
  for (const int e : patch) {
    const FabricElement& element = fabric.elements[static_cast<size_t>(e)];
    Sample mean;
    for (int q = 0; q < element.points; ++q) {
      const TensionPoint& p = fabric.points[static_cast<size_t>(element.first_point) + static_cast<size_t>(q)];
      if (p.area > 0.0) mean.add({p.position, fit.pressure(p, tension), p.area});
    }
    if (element.nodes == 4) {
      all_.push_back(mean);
      continue;
    }
    for (size_t i = 0; i < 3; ++i)
      sides.push_back({std::minmax({element.site[i], element.site[(i + 1) % 3]}), triangles_.size()});
    triangles_.push_back(mean);
  }
  pair_triangles(std::move(sides));
}

/// A sample for each side between two triangles, with a third of their areas.
void Samples::pair_triangles(std::vector<Side> sides) {
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.sites < b.sites; });
  std::vector<bool> paired(triangles_.size(), false);
  for (size_t i = 0; i + 1 < sides.size(); ++i) {
    if (sides[i].sites != sides[i + 1].sites) continue;
    Sample pair = triangles_[sides[i].triangle];
    pair.add(triangles_[sides[i + 1].triangle]);
    pair.area /= 3.0;
    all_.push_back(pair);
    paired[sides[i].triangle] = paired[sides[i + 1].triangle] = true;
  }
  for (size_t t = 0; t < paired.size(); ++t)
    if (!paired[t]) all_.push_back(triangles_[t]);
}

}  // namespace

std::optional<double> fitted_pressure(const FabricInContact& fabric, const std::vector<int>& patch,
                                      const ContactCluster& place, Tension tension, int degree) {
  Fit fit(place, degree);
  const Samples samples(fabric, patch, fit, tension);
  double squares = 0.0, area = 0.0;
  for (const Sample& s : samples.all()) {
    squares += s.area * (s.position - place.position).squaredNorm();
    area += s.area;
  }
  if (!(squares > 0.0)) return std::nullopt;
  for (const Sample& s : samples.all()) fit.add(s, std::sqrt(area / squares));
  return fit.value();
}

}  // namespace toile::contact
