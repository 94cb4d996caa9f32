#include "figure/turn_arms.hpp"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "figure/cut_limb.hpp"
#include "figure/operators.hpp"
#include "toile/base/error.hpp"

namespace toile::body {
namespace {

constexpr double radians_per_degree = M_PI / 180.0;

double angle_of_side(const Landmarks& landmarks, int side) {
  const std::string name = side > 0 ? "left " : "right ";
  const Vec3 along = landmarks.at(name + "elbow").point - landmarks.at(name + "upper arm").point;
  return std::atan2(-along.z(), side * along.x()) / radians_per_degree;
}

/// Smooth weights from 0 on the trunk to 1 on the arm; what is neither decides the least bending.
Eigen::VectorXd weights(const TriangleMesh& form, const std::vector<char>& arm, const std::vector<char>& trunk) {
  constexpr double held = 1.0;  // 1/mm^2, against bending of 1e-4 or so
  SparseMatrix system = bending_of(form);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(system.rows());
  for (int v = 0; v < system.rows(); ++v) {
    if (arm[v] || trunk[v]) {
      system.coeffRef(v, v) += held;
      right[v] = arm[v] ? held : 0.0;
    }
  }
  const Eigen::SimplicialLDLT<SparseMatrix> solver(system);
  return solver.solve(right).cwiseMax(0.0).cwiseMin(1.0);
}

void turn_arm(const Landmarks& landmarks, int side, double angle, TriangleMesh* form) {
  const std::string name = side > 0 ? "left " : "right ";
  const Landmark& upper = landmarks.at(name + "upper arm");
  const Vec3 armpit = landmarks.at(name + "armpit").point, shoulder = landmarks.at(name + "shoulder").point;
  const Vec3 joint = 0.5 * (armpit + shoulder);
  const double reach = (upper.point - joint).norm();
  const std::vector<char> arm = beyond(*form, upper.point - 0.25 * reach * upper.normal, upper.normal);
  std::vector<char> trunk(form->vertices.size(), 0);
  // The arm from just outside the armpit on.
  constexpr double outside_armpit = 6.0;  // mm
  const double back = (upper.point - armpit).dot(upper.normal) - outside_armpit;
  const std::vector<char> outside = beyond(*form, upper.point - back * upper.normal, upper.normal);
  for (std::size_t v = 0; v < trunk.size(); ++v) {
    const Vec3 away = form->vertices[v] - joint;
    trunk[v] = !arm[v] && !outside[v] && away.norm() > 1.1 * reach;
  }
  const double turn = side * (angle - angle_of_side(landmarks, side)) * radians_per_degree;
  const Eigen::VectorXd weight = weights(*form, arm, trunk);
  for (std::size_t v = 0; v < form->vertices.size(); ++v) {
    const Eigen::AngleAxisd rotation(weight[v] * turn, Vec3::UnitY());
    form->vertices[v] = joint + rotation * (form->vertices[v] - joint);
  }
}

}  // namespace

double arm_angle(const Landmarks& landmarks) {
  return 0.5 * (angle_of_side(landmarks, 1) + angle_of_side(landmarks, -1));
}

TriangleMesh turn_arms(const TriangleMesh& form, const Landmarks& landmarks, double angle) {
  constexpr double least = 15.0, greatest = 85.0;
  if (!(angle >= least && angle <= greatest)) {
    std::ostringstream text;
    text << "the arms cannot be held " << angle << " degrees below the level; allowed are " << least << " to "
         << greatest << ", and what the trunk leaves room for";
    throw base::InputError(text.str());
  }
  TriangleMesh turned = form;
  turn_arm(landmarks, 1, angle, &turned);
  turn_arm(landmarks, -1, angle, &turned);
  return turned;
}

}  // namespace toile::body
