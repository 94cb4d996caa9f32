#include "shell_support.hpp"

#include <cmath>

namespace toile::element::testing {
namespace {

/// Position and unit director (nearly normal) of a saddle over the pattern.
Eigen::Matrix<double, 6, 1> saddle(double X, double Y, double tilt) {
  Eigen::Matrix<double, 6, 1> node;
  const Eigen::Vector3d normal(-0.04 * X - 0.01 * Y + tilt, 0.03 * Y - 0.01 * X, 1.0);
  node << 1.1 * X, 0.95 * Y, 0.02 * X * X + 0.01 * X * Y - 0.015 * Y * Y, normal.normalized();
  return node;
}

/// Orthonormal frame whose third axis is d, turned about it by `angle`.
Eigen::Matrix3d frame_of(const Eigen::Vector3d& d, double angle) {
  Eigen::Matrix3d frame;
  const Eigen::Vector3d t = d.unitOrthogonal(), u = d.cross(t);
  frame << std::cos(angle) * t + std::sin(angle) * u, std::cos(angle) * u - std::sin(angle) * t, d;
  return frame;
}

void append(std::vector<double>& values, const Eigen::MatrixXd& more) {
  values.insert(values.end(), more.data(), more.data() + more.size());
}

}  // namespace

void freeze(Arrays& shells) {
  shells.frozen.resize(static_cast<std::size_t>(shells.size()) * shells.element->frozen_values());
  shells.element->freeze(shells.batch(), shells.frozen.data());
}

void carry_frames(Arrays& shells) {
  for (std::size_t node = 0; node < shells.x.size() / 5; ++node) {
    Eigen::Map<Eigen::Vector2d> w(&shells.x[5 * node + 3]);
    Eigen::Map<Eigen::Matrix3d> frame(&shells.frames[9 * node]);
    const Eigen::Vector3d axis = w[0] * frame.col(1) - w[1] * frame.col(0);
    frame = (Eigen::AngleAxisd(axis.norm(), axis.normalized()) * frame).eval();
    w.setZero();
  }
}

Arrays random_shells(const Element& element, const Law& law, int n, unsigned seed, bool curved) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const double corners[4][2] = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  Arrays arrays;
  arrays.element = &element;
  arrays.law = law;
  arrays.shear_modulus = 0.02;
  for (int e = 0; e < n; ++e) {
    const Eigen::Vector3d about(unit(random), unit(random), 1.0);
    const Eigen::Matrix3d pose(Eigen::AngleAxisd(3.0 * unit(random), about.normalized()));
    for (int i = 0; i < element.nodes(); ++i) {
      const double X = corners[i][0] + 1.5 * unit(random), Y = corners[i][1] + 1.5 * unit(random);
      Eigen::Matrix<double, 6, 1> node = saddle(X, Y, 0.1 * unit(random));
      if (!curved) node << X, Y, 0.0, 0.0, 0.0, 1.0;
      const Eigen::Vector3d noise(unit(random), unit(random), unit(random));
      const Eigen::Vector3d wavy(1.3 * node[0] + 0.2 * node[1], 1.2 * node[1], node[2]);
      append(arrays.pattern, Eigen::Vector2d(X, Y));
      append(arrays.x, pose * (wavy + 0.4 * noise));
      append(arrays.x, Eigen::Vector2d(0.3 * unit(random), 0.3 * unit(random)));
      append(arrays.frames, frame_of((pose * (node.tail<3>() + 0.1 * noise)).normalized(), 3.0 * unit(random)));
      if (curved) append(arrays.reference, node);
    }
    arrays.wale_angle.push_back(3.0 * unit(random));
  }
  freeze(arrays);
  return arrays;
}

Arrays at_rest(const Arrays& shells, const Eigen::Matrix3d& Q, const Eigen::Vector3d& shift) {
  Arrays rest = shells;
  for (std::size_t node = 0; node < shells.x.size() / 5; ++node) {
    Eigen::Vector3d X(shells.pattern[2 * node], shells.pattern[2 * node + 1], 0.0), D(0.0, 0.0, 1.0);
    if (!shells.reference.empty()) {
      X = Eigen::Map<const Eigen::Vector3d>(&shells.reference[6 * node]);
      D = Eigen::Map<const Eigen::Vector3d>(&shells.reference[6 * node + 3]);
    }
    Eigen::Map<Eigen::Vector3d>(&rest.x[5 * node]) = Q * X + shift;
    Eigen::Map<Eigen::Vector2d>(&rest.x[5 * node + 3]).setZero();
    Eigen::Map<Eigen::Matrix3d>(&rest.frames[9 * node]) = frame_of(Q * D, 0.7 * static_cast<double>(node));
  }
  freeze(rest);
  return rest;
}

Arrays flat_shells(const PlaneMesh& mesh, const Element& element, const Law& law, double wale_angle) {
  Arrays arrays;
  arrays.element = &element;
  arrays.law = law;
  arrays.shear_modulus = 0.02;
  arrays.wale_angle.assign(mesh.elements(), wale_angle);
  for (const int node : mesh.connectivity) {
    const Eigen::Vector2d& X = mesh.nodes[node];
    append(arrays.pattern, X);
    arrays.x.insert(arrays.x.end(), {X[0], X[1], 0.0, 0.0, 0.0});
    append(arrays.frames, Eigen::Matrix3d::Identity());
  }
  freeze(arrays);
  return arrays;
}

Eigen::VectorXd constant_curvature(const PlaneMesh& mesh, double k11, double k22, double k12) {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(5 * mesh.nodes.size());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const double X = mesh.nodes[i][0], Y = mesh.nodes[i][1];
    u[5 * i + 2] = 0.5 * (k11 * X * X + k22 * Y * Y) + k12 * X * Y;
    u.segment<2>(5 * i + 3) << -k11 * X - k12 * Y, -k22 * Y - k12 * X;
  }
  return u;
}

Eigen::VectorXd constant_shear(const PlaneMesh& mesh, const Eigen::Vector2d& gamma) {
  const Eigen::Vector2d slope(0.5, 0.1);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(5 * mesh.nodes.size());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    u[5 * i + 2] = slope.dot(mesh.nodes[i]);
    u.segment<2>(5 * i + 3) = gamma - slope;
  }
  return u;
}

Eigen::VectorXd scatter_shells(const PlaneMesh& mesh, const Eigen::VectorXd& element_vectors) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(5 * mesh.nodes.size());
  for (std::size_t k = 0; k < mesh.connectivity.size(); ++k) {
    sum.segment<5>(5 * mesh.connectivity[k]) += element_vectors.segment<5>(5 * k);
  }
  return sum;
}

}  // namespace toile::element::testing
