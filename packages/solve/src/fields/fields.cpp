#include "toile/solve/fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/block_arrays.hpp"
#include "fields/contact_pressure.hpp"
#include "fields/element_fields.hpp"

namespace toile::solve {

namespace {

/// The points of an element count alike.
std::array<double, 3> wrinkle_shares(const Problem& problem, size_t b, const element::PointFields& points) {
  if (points.wrinkle_state.empty()) return {1.0, 0.0, 0.0};
  const mesh::Block& block = problem.mesh->blocks[b];
  const size_t per = static_cast<size_t>(problem.models[b].element->points());
  std::array<double, 3> shares{};
  double total = 0.0;
  for (size_t k = 0; k < points.wrinkle_state.size(); ++k) {
    const double area = mesh::pattern_area(*problem.mesh, block, k / per);
    shares[static_cast<size_t>(points.wrinkle_state[k])] += area;
    total += area;
  }
  for (double& share : shares) share /= total;
  return shares;
}

/// [element] means of one block.
std::vector<Eigen::Matrix3d> mean_tensions(const BlockModel& model, const element::Batch& batch) {
  const element::PointTensions points = model.element->tensions(batch);
  const size_t per = static_cast<size_t>(model.element->points());
  std::vector<Eigen::Matrix3d> means(static_cast<size_t>(batch.n), Eigen::Matrix3d::Zero());
  for (size_t q = 0; q < means.size() * per; ++q)
    means[q / per] += Eigen::Map<const Eigen::Matrix3d>(&points.tension[9 * q]) / static_cast<double>(per);
  return means;
}

void add_block(const Problem& problem, size_t b, const State& state, Fields& out) {
  const mesh::Block& block = problem.mesh->blocks[b];
  const BlockModel& model = problem.models[b];
  const BlockArrays arrays(problem, b, state, out.position);
  std::vector<double> areas(block.connectivity.size());
  model.element->nodal_areas(arrays.batch(), areas.data());
  for (size_t i = 0; i < areas.size(); ++i) out.area[block.connectivity[i]] += areas[i];

  const element::PointFields points = model.element->fields(arrays.batch());
  const double* crossing = problem.crossings ? &out.crossings.length[out.tension.size()] : nullptr;
  out.element.push_back(element_values(problem, points, block.size(), model.material->thickness(), crossing));
  const std::vector<Eigen::Matrix3d> tensions = mean_tensions(model, arrays.batch());
  out.tension.insert(out.tension.end(), tensions.begin(), tensions.end());
  const size_t per = static_cast<size_t>(model.element->points());
  for (size_t k = 0; k < points.status.size(); ++k) {
    const double minor = points.cauchy_principal[2 * k + 1];
    if (!(minor < out.smallest_principal_stress)) continue;
    out.smallest_principal_stress = minor;
    out.smallest_stress_block = static_cast<int>(b);
  }
  const std::vector<double>& wale = named(out.element.back(), "stretch_wale").values;
  const std::vector<double>& course = named(out.element.back(), "stretch_course").values;
  for (size_t k = 0; k < points.status.size(); ++k) {
    const double fibre = std::max(wale[k / per], course[k / per]);
    if (points.status[k] != material::point_extrapolated || !(fibre > out.largest_extrapolation)) continue;
    out.largest_extrapolation = fibre;
    out.extrapolated_where = "panel \"" + block.name + "\", element " + std::to_string(k / per + 1);
  }
  out.wrinkle_shares.push_back(wrinkle_shares(problem, b, points));
}

}  // namespace

Fields compute_fields(const Problem& problem, const State& state, const Accuracy& accuracy) {
  const size_t nodes = static_cast<size_t>(problem.mesh->nodes());
  Fields out;
  out.position = node_positions(problem, state);
  out.pressure.assign(nodes, 0.0);
  out.pressure_error.assign(nodes, 0.0);
  for (const ErrorPart& part : error_parts()) (out.errors.*part.values).assign(nodes, 0.0);
  out.body_change.assign(nodes, 0.0);
  out.contact_force.assign(nodes, 0.0);
  out.gap.assign(nodes, 0.0);
  out.offset.assign(nodes, 0.0);
  out.normal.assign(nodes, Vec3::Zero());
  out.area.assign(nodes, 0.0);
  out.smallest_principal_stress = std::numeric_limits<double>::infinity();
  if (problem.crossings) out.crossings = crossing::find_crossings(*problem.mesh, problem.clusters, out.position);
  for (size_t b = 0; b < problem.mesh->blocks.size(); ++b) add_block(problem, b, state, out);
  if (problem.surface != nullptr) add_contact_pressure(problem, state, accuracy, out);
  return out;
}

Vec3 contact_resultant(const Fields& fields) {
  Vec3 sum = Vec3::Zero();
  for (size_t n = 0; n < fields.contact_force.size(); ++n) sum += fields.contact_force[n] * fields.normal[n];
  return sum;
}

Vec3 contact_resultant_error(const Fields& fields) {
  Vec3 sum = Vec3::Zero();
  for (size_t n = 0; n < fields.pressure_error.size(); ++n)
    sum += fields.pressure_error[n] * fields.area[n] * fields.normal[n].cwiseAbs();
  return sum;
}

Vec3 pressure_resultant(const Fields& fields) {
  Vec3 sum = Vec3::Zero();
  for (size_t n = 0; n < fields.pressure.size(); ++n) sum += fields.pressure[n] * fields.area[n] * fields.normal[n];
  return sum;
}

}  // namespace toile::solve
