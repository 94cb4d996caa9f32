#include "toile/solve/fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "block_arrays.hpp"
#include "contact_pressure.hpp"

namespace toile::solve {

namespace {

enum ElementField {
  stretch_wale,
  stretch_course,
  stretch_major,
  stretch_minor,
  stress_wale,
  stress_course,
  stress_shear,
  cauchy_major,
  cauchy_minor,
  tension_wale,
  tension_course,
  energy_density,
  thickness,
  extrapolated,
  wrinkle_state,
  wrinkle_x,
  wrinkle_y,
  wrinkle_z,
  field_count
};

struct PointMean {
  double values[field_count] = {};

  void add(const element::PointFields& f, size_t point, double h0, double weight) {
    const double* C = &f.C[3 * point];
    const double* S = &f.S[3 * point];
    const double mean = 0.5 * (C[0] + C[1]), radius = std::hypot(0.5 * (C[0] - C[1]), C[2]);
    const double wale = std::sqrt(C[0]), course = std::sqrt(C[1]);
    const double h = h0 * f.thickness_stretch[point];
    values[stretch_wale] += weight * wale;
    values[stretch_course] += weight * course;
    values[stretch_major] += weight * std::sqrt(mean + radius);
    values[stretch_minor] += weight * std::sqrt(std::max(0.0, mean - radius));
    values[stress_wale] += weight * S[0];
    values[stress_course] += weight * S[1];
    values[stress_shear] += weight * S[2];
    values[cauchy_major] += weight * f.cauchy_principal[2 * point];
    values[cauchy_minor] += weight * f.cauchy_principal[2 * point + 1];
    // Tension along the deformed yarns: h e.sigma.e = h0 e.F S F^T.e / area stretch, with e = F N / |F N|.
    const double force = weight * h0 / std::sqrt(C[0] * C[1] - C[2] * C[2]);
    values[tension_wale] += force * (C[0] * C[0] * S[0] + 2.0 * C[0] * C[2] * S[2] + C[2] * C[2] * S[1]) / C[0];
    values[tension_course] += force * (C[1] * C[1] * S[1] + 2.0 * C[1] * C[2] * S[2] + C[2] * C[2] * S[0]) / C[1];
    values[energy_density] += weight * f.energy_density[point];
    values[thickness] += weight * h;
    values[extrapolated] = std::max(values[extrapolated], f.status[point] == material::point_extrapolated ? 1.0 : 0.0);
    if (!f.wrinkle_state.empty()) add_wrinkles(f, point);
  }

  /// The state that is furthest from taut, and the sum of the crests, each turned to the same side as the others.
  void add_wrinkles(const element::PointFields& f, size_t point) {
    values[wrinkle_state] = std::max(values[wrinkle_state], static_cast<double>(f.wrinkle_state[point]));
    double* sum = &values[wrinkle_x];
    const double* crest = &f.wrinkle_crest[3 * point];
    const double sign = sum[0] * crest[0] + sum[1] * crest[1] + sum[2] * crest[2] < 0.0 ? -1.0 : 1.0;
    for (int d = 0; d < 3; ++d) sum[d] += sign * crest[d];
  }

  void normalise_crest() {
    double* sum = &values[wrinkle_x];
    const double length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    for (int d = 0; d < 3 && length > 0.0; ++d) sum[d] /= length;
  }
};

double pattern_area(const mesh::Mesh& mesh, const mesh::Block& block, size_t e) {
  const size_t per = static_cast<size_t>(block.nodes_per_element);
  const auto corner = [&](size_t i) { return mesh.pattern[block.connectivity[e * per + i % per]]; };
  double twice = 0.0;
  for (size_t i = 0; i < per; ++i) twice += corner(i).x() * corner(i + 1).y() - corner(i + 1).x() * corner(i).y();
  return 0.5 * std::abs(twice);
}

/// The points of an element count alike.
std::array<double, 3> wrinkle_shares(const Problem& problem, size_t b, const element::PointFields& points) {
  if (points.wrinkle_state.empty()) return {1.0, 0.0, 0.0};
  const mesh::Block& block = problem.mesh->blocks[b];
  const size_t per = static_cast<size_t>(problem.laws[b].element->points());
  std::array<double, 3> shares{};
  double total = 0.0;
  for (size_t k = 0; k < points.wrinkle_state.size(); ++k) {
    const double area = pattern_area(*problem.mesh, block, k / per);
    shares[static_cast<size_t>(points.wrinkle_state[k])] += area;
    total += area;
  }
  for (double& share : shares) share /= total;
  return shares;
}

void add_block(const Problem& problem, size_t b, const State& state, Fields& out) {
  const mesh::Block& block = problem.mesh->blocks[b];
  const BlockLaw& law = problem.laws[b];
  const BlockArrays arrays(problem, b, state, out.position);
  std::vector<double> areas(block.connectivity.size());
  law.element->nodal_areas(arrays.batch(), areas.data());
  for (size_t i = 0; i < areas.size(); ++i) out.area[block.connectivity[i]] += areas[i];

  const element::PointFields points = law.element->fields(arrays.batch());
  const size_t per = static_cast<size_t>(law.element->points());
  std::vector<NamedField> fields;
  for (const std::string& name : element_field_names(problem))
    fields.push_back({name, std::vector<double>(static_cast<size_t>(block.size()))});
  for (size_t e = 0; e < static_cast<size_t>(block.size()); ++e) {
    PointMean mean;
    for (size_t q = 0; q < per; ++q) {
      mean.add(points, e * per + q, law.material->thickness(), 1.0 / static_cast<double>(per));
      const double minor = points.cauchy_principal[2 * (e * per + q) + 1];
      if (!(minor < out.smallest_principal_stress)) continue;
      out.smallest_principal_stress = minor;
      out.smallest_stress_block = static_cast<int>(b);
    }
    mean.normalise_crest();
    for (size_t k = 0; k < fields.size(); ++k) fields[k].values[e] = mean.values[k];
    const double fibre = std::max(mean.values[stretch_wale], mean.values[stretch_course]);
    if (mean.values[extrapolated] > 0.0 && fibre > out.largest_extrapolation) {
      out.largest_extrapolation = fibre;
      out.extrapolated_where = "panel \"" + block.name + "\", element " + std::to_string(e + 1);
    }
  }
  out.element.push_back(std::move(fields));
  out.wrinkle_shares.push_back(wrinkle_shares(problem, b, points));
}

}  // namespace

std::vector<std::string> element_field_names(const Problem& problem) {
  std::vector<std::string> names = {"stretch_wale", "stretch_course", "stretch_major",  "stretch_minor",
                                    "stress_wale",  "stress_course",  "stress_shear",   "cauchy_major",
                                    "cauchy_minor", "tension_wale",   "tension_course", "energy_density",
                                    "thickness",    "extrapolated"};
  const auto relaxes = [](const BlockLaw& law) { return law.material->response().relaxes(); };
  if (std::any_of(problem.laws.begin(), problem.laws.end(), relaxes))
    names.insert(names.end(), {"wrinkle_state", "wrinkle_x", "wrinkle_y", "wrinkle_z"});
  return names;
}

Fields compute_fields(const Problem& problem, const State& state) {
  const size_t nodes = static_cast<size_t>(problem.mesh->nodes());
  Fields out;
  out.position = node_positions(problem, state);
  out.pressure.assign(nodes, 0.0);
  out.pressure_error.assign(nodes, 0.0);
  out.contact_force.assign(nodes, 0.0);
  out.gap.assign(nodes, 0.0);
  out.normal.assign(nodes, Vec3::Zero());
  out.area.assign(nodes, 0.0);
  out.smallest_principal_stress = std::numeric_limits<double>::infinity();
  for (size_t b = 0; b < problem.mesh->blocks.size(); ++b) add_block(problem, b, state, out);
  if (problem.surface != nullptr) add_contact_pressure(problem, state, out);
  return out;
}

Vec3 contact_resultant(const Fields& fields) {
  Vec3 sum = Vec3::Zero();
  for (size_t n = 0; n < fields.contact_force.size(); ++n) sum += fields.contact_force[n] * fields.normal[n];
  return sum;
}

Vec3 pressure_resultant(const Fields& fields) {
  Vec3 sum = Vec3::Zero();
  for (size_t n = 0; n < fields.pressure.size(); ++n) sum += fields.pressure[n] * fields.area[n] * fields.normal[n];
  return sum;
}

}  // namespace toile::solve
