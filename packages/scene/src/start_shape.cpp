#include "start_shape.hpp"

#include <Eigen/LU>
#include <cmath>

namespace toile::scene {

solve::Vec3 Deformation::along(double angle) const {
  return F * mesh::Vec2(std::cos(angle), std::sin(angle));
}

solve::Vec3 Deformation::course() const {
  return along(wale_angle + M_PI_2);
}

std::pair<double, double> Deformation::principal() const {
  const Eigen::Matrix2d C = F.transpose() * F;
  const double mean = 0.5 * C.trace(), radius = std::hypot(0.5 * (C(0, 0) - C(1, 1)), C(0, 1));
  return {std::sqrt(mean + radius), std::sqrt(std::max(0.0, mean - radius))};
}

namespace {

/// Change of a nodal field along two sides of an element, of a quadrilateral at its centre.
template <class Point>
Eigen::Matrix<double, Point::RowsAtCompileTime, 2> sides(const std::vector<Point>& at, const int* node, size_t per) {
  Eigen::Matrix<double, Point::RowsAtCompileTime, 2> side;
  side.col(0) = at[node[1]] - at[node[0]];
  side.col(1) = at[node[per - 1]] - at[node[0]];
  if (per == 4) {
    side.col(0) = 0.5 * (side.col(0) + at[node[2]] - at[node[3]]);
    side.col(1) = 0.5 * (side.col(1) + at[node[2]] - at[node[1]]);
  }
  return side;
}

}  // namespace

std::vector<Deformation> deformations(const mesh::Mesh& mesh, const mesh::Block& block,
                                      const std::vector<solve::Vec3>& position) {
  const size_t per = static_cast<size_t>(block.nodes_per_element);
  std::vector<Deformation> all;
  for (size_t e = 0; e < static_cast<size_t>(block.size()); ++e) {
    const int* node = &block.connectivity[e * per];
    Deformation d;
    d.F = sides(position, node, per) * sides(mesh.pattern, node, per).inverse();
    for (size_t i = 0; i < per; ++i) d.centre += position[node[i]] / static_cast<double>(per);
    d.wale_angle = block.wale_angle[e];
    all.push_back(d);
  }
  return all;
}

double length_of_line(const std::vector<int>& nodes, const std::vector<solve::Vec3>& position) {
  double length = 0.0;
  for (size_t k = 1; k < nodes.size(); ++k) length += (position[nodes[k]] - position[nodes[k - 1]]).norm();
  return length;
}

double mean_side(const mesh::Block& block, const std::vector<solve::Vec3>& position) {
  const size_t per = static_cast<size_t>(block.nodes_per_element);
  double sum = 0.0;
  for (size_t i = 0; i < block.connectivity.size(); ++i)
    sum += (position[block.connectivity[i]] - position[block.connectivity[i - i % per + (i + 1) % per]]).norm();
  return sum / static_cast<double>(block.connectivity.size());
}

std::string panel_of_edge(const std::string& edge) {
  return edge.substr(0, edge.rfind('.'));
}

bool is_side(const std::string& edge) {
  const std::string side = edge.substr(edge.rfind('.') + 1);
  return side == "left" || side == "right";
}

}  // namespace toile::scene
