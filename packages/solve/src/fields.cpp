#include "toile/solve/fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "toile/contact/normal_contact.hpp"

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
    // Tension along the deformed yarns: h e.sigma.e with e = F N / |F N| and sigma = F S F^T (det F = 1).
    values[tension_wale] += weight * h * (C[0] * C[0] * S[0] + 2.0 * C[0] * C[2] * S[2] + C[2] * C[2] * S[1]) / C[0];
    values[tension_course] += weight * h * (C[1] * C[1] * S[1] + 2.0 * C[1] * C[2] * S[2] + C[2] * C[2] * S[0]) / C[1];
    values[energy_density] += weight * f.energy_density[point];
    values[thickness] += weight * h;
    values[extrapolated] = std::max(values[extrapolated], f.status[point] == material::point_extrapolated ? 1.0 : 0.0);
  }
};

/// Arrays of one whole block in the layout of element::Batch.
struct BlockArrays {
  std::vector<double> pattern, x, params;
  element::Batch batch;
};

BlockArrays arrays_of(const mesh::Mesh& mesh, const mesh::Block& block, const BlockLaw& law,
                      const std::vector<Vec3>& position) {
  BlockArrays a;
  for (const int n : block.connectivity) {
    a.pattern.insert(a.pattern.end(), {mesh.pattern[n][0], mesh.pattern[n][1]});
    a.x.insert(a.x.end(), {position[n][0], position[n][1], position[n][2]});
  }
  a.params = law.material->graduated() ? std::vector<double>() : law.material->params();
  for (int e = 0; e < block.size() && law.material->graduated(); ++e) {
    const std::vector<double> values = law.material->params_at(block.position[e]);
    a.params.insert(a.params.end(), values.begin(), values.end());
  }
  a.batch.n = block.size();
  a.batch.pattern = a.pattern.data();
  a.batch.x = a.x.data();
  a.batch.wale_angle = block.wale_angle.data();
  a.batch.law = &law.material->law();
  a.batch.params = a.params.data();
  a.batch.graduated = law.material->graduated();
  a.batch.thickness = law.material->thickness();
  return a;
}

void add_block(const Problem& problem, size_t b, Fields& out) {
  const mesh::Block& block = problem.mesh->blocks[b];
  const BlockLaw& law = problem.laws[b];
  const BlockArrays arrays = arrays_of(*problem.mesh, block, law, out.position);
  std::vector<double> areas(block.connectivity.size());
  law.element->nodal_areas(arrays.batch, areas.data());
  for (size_t i = 0; i < areas.size(); ++i) out.area[block.connectivity[i]] += areas[i];

  const element::PointFields points = law.element->fields(arrays.batch);
  const size_t per = static_cast<size_t>(law.element->points());
  std::vector<NamedField> fields;
  for (const std::string& name : element_field_names())
    fields.push_back({name, std::vector<double>(static_cast<size_t>(block.size()))});
  for (size_t e = 0; e < static_cast<size_t>(block.size()); ++e) {
    PointMean mean;
    for (size_t q = 0; q < per; ++q) {
      mean.add(points, e * per + q, law.material->thickness(), 1.0 / static_cast<double>(per));
      out.smallest_principal_stress =
          std::min(out.smallest_principal_stress, points.cauchy_principal[2 * (e * per + q) + 1]);
    }
    for (size_t k = 0; k < field_count; ++k) fields[k].values[e] = mean.values[k];
    const double fibre = std::max(mean.values[stretch_wale], mean.values[stretch_course]);
    if (mean.values[extrapolated] > 0.0 && fibre > out.largest_extrapolation) {
      out.largest_extrapolation = fibre;
      out.extrapolated_where = "panel \"" + block.name + "\", element " + std::to_string(e + 1);
    }
  }
  out.element.push_back(std::move(fields));
}

void add_contact(const Problem& problem, const State& state, Fields& out) {
  for (size_t c = 0; c < problem.clusters.size(); ++c) {
    double area = 0.0;
    for (const int n : problem.clusters[c]) area += out.area[n];
    for (const int n : problem.clusters[c]) {
      const body::SurfacePoint p = problem.surface->closest(out.position[n]);
      out.pressure[n] = contact::pressure(state.contact_force[c], area);
      out.gap[n] = p.gap - state.offset[c];
      out.normal[n] = p.normal;
      if (n == problem.clusters[c].front() && out.pressure[n] > 0.0 && !p.found) ++out.contacts_off_surface;
    }
  }
}

}  // namespace

const std::vector<std::string>& element_field_names() {
  static const std::vector<std::string> names = {"stretch_wale", "stretch_course", "stretch_major",  "stretch_minor",
                                                 "stress_wale",  "stress_course",  "stress_shear",   "cauchy_major",
                                                 "cauchy_minor", "tension_wale",   "tension_course", "energy_density",
                                                 "thickness",    "extrapolated"};
  return names;
}

Fields compute_fields(const Problem& problem, const State& state) {
  const size_t nodes = static_cast<size_t>(problem.mesh->nodes());
  Fields out;
  out.position.resize(nodes);
  out.pressure.assign(nodes, 0.0);
  out.gap.assign(nodes, 0.0);
  out.normal.assign(nodes, Vec3::Zero());
  out.area.assign(nodes, 0.0);
  out.smallest_principal_stress = std::numeric_limits<double>::infinity();
  for (size_t c = 0; c < problem.clusters.size(); ++c)
    for (const int n : problem.clusters[c]) out.position[n] = node_position(problem, state, static_cast<int>(c), n);
  for (size_t b = 0; b < problem.mesh->blocks.size(); ++b) add_block(problem, b, out);
  if (problem.surface != nullptr) add_contact(problem, state, out);
  return out;
}

Vec3 pressure_resultant(const Fields& fields) {
  Vec3 sum = Vec3::Zero();
  for (size_t n = 0; n < fields.pressure.size(); ++n) sum += fields.pressure[n] * fields.area[n] * fields.normal[n];
  return sum;
}

}  // namespace toile::solve
