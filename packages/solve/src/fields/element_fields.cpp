#include "fields/element_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fields/field_names.hpp"

namespace toile::solve {

namespace {

/// What is known of the fabric at one integration point.
struct FieldPoint {
  const double* C;       ///< C11, C22, C12 in the material frame
  const double* S;       ///< second Piola-Kirchhoff stress, MPa
  const double* cauchy;  ///< principal Cauchy stresses, MPa, larger first
  double energy_density;
  double thickness;  ///< undeformed, mm
  double thickness_stretch;
  bool extrapolated;
  int wrinkle_state;    ///< 0 where the fabric does not relax
  const double* crest;  ///< [3]
  double crossing;      ///< of the whole element, mm

  double mean() const { return 0.5 * (C[0] + C[1]); }
  double radius() const { return std::hypot(0.5 * (C[0] - C[1]), C[2]); }
  double area_stretch() const { return std::sqrt(C[0] * C[1] - C[2] * C[2]); }
};

/// How the value of an element comes from those of its points.
enum class Over {
  mean,
  largest,
  line  ///< unit vector of the points' sum, each turned to the same side as the others
};

struct ElementField {
  const char* name;
  const char* unit;
  const char* text;
  double (*value)(const FieldPoint& point, int component);
  Over over = Over::mean;
  bool (*is_there)(const Problem& problem) = [](const Problem&) { return true; };
  int components = 1;
};

bool relaxes(const Problem& problem) {
  return std::any_of(problem.models.begin(), problem.models.end(),
                     [](const BlockModel& model) { return model.material->response().relaxes(); });
}

bool looks_for_crossings(const Problem& problem) {
  return problem.crossings;
}

// One entry a field: what is written, described and documented comes from here.
// Tension along the deformed yarns: h e.sigma.e = h0 e.F S F^T.e / area stretch, with e = F N / |F N|.
const ElementField table[] = {
    {"stretch_wale", "", "stretch of the fabric's wales", [](const FieldPoint& p, int) { return std::sqrt(p.C[0]); }},
    {"stretch_course", "", "stretch of its courses", [](const FieldPoint& p, int) { return std::sqrt(p.C[1]); }},
    {"stretch_major", "", "larger principal stretch",
     [](const FieldPoint& p, int) { return std::sqrt(p.mean() + p.radius()); }},
    {"stretch_minor", "", "smaller principal stretch",
     [](const FieldPoint& p, int) { return std::sqrt(std::max(0.0, p.mean() - p.radius())); }},
    {"stress_wale", "MPa", "second Piola-Kirchhoff stress in the fabric's directions",
     [](const FieldPoint& p, int) { return p.S[0]; }},
    {"stress_course", "MPa", "second Piola-Kirchhoff stress in the fabric's directions",
     [](const FieldPoint& p, int) { return p.S[1]; }},
    {"stress_shear", "MPa", "second Piola-Kirchhoff stress in the fabric's directions",
     [](const FieldPoint& p, int) { return p.S[2]; }},
    {"cauchy_major", "MPa", "larger principal Cauchy stress", [](const FieldPoint& p, int) { return p.cauchy[0]; }},
    {"cauchy_minor", "MPa",
     "smaller principal Cauchy stress; negative: the fabric would wrinkle (with `compression` = tension field it does, "
     "and this is not negative)",
     [](const FieldPoint& p, int) { return p.cauchy[1]; }},
    {"tension_wale", "N/mm", "force per current length along the deformed wales",
     [](const FieldPoint& p, int) {
       const double *C = p.C, *S = p.S;
       return p.thickness / p.area_stretch() * (C[0] * C[0] * S[0] + 2.0 * C[0] * C[2] * S[2] + C[2] * C[2] * S[1]) /
              C[0];
     }},
    {"tension_course", "N/mm", "force per current length along the deformed courses",
     [](const FieldPoint& p, int) {
       const double *C = p.C, *S = p.S;
       return p.thickness / p.area_stretch() * (C[1] * C[1] * S[1] + 2.0 * C[1] * C[2] * S[2] + C[2] * C[2] * S[0]) /
              C[1];
     }},
    {"energy_density", "MPa", "strain energy per reference volume",
     [](const FieldPoint& p, int) { return p.energy_density; }},
    {"thickness", "mm", "current thickness",
     [](const FieldPoint& p, int) { return p.thickness * p.thickness_stretch; }},
    {"extrapolated", "", "above 0: outside the calibrated range of the fabric",
     [](const FieldPoint& p, int) { return p.extrapolated ? 1.0 : 0.0; }, Over::largest},
    {"wrinkle_state", "",
     "0 taut, 1 wrinkled, 2 slack: the largest in the element. Only where a fabric's `compression` is relaxed; of "
     "shells at the mid-surface",
     [](const FieldPoint& p, int) { return static_cast<double>(p.wrinkle_state); }, Over::largest, relaxes},
    {"wrinkle", "", "unit vector along the crests of the wrinkles; zero where there are none",
     [](const FieldPoint& p, int d) { return p.crest[d]; }, Over::line, relaxes, 3},
    {"crossing", "mm",
     "length of the lines along which the element passes through fabric that it is not joined to; 0 where none does. "
     "Only with `crossings` of the list Output",
     [](const FieldPoint& p, int) { return p.crossing; }, Over::largest, looks_for_crossings},
};

FieldPoint fabric_point(const element::PointFields& f, size_t point, double thickness, double crossing) {
  static constexpr double no_crest[3] = {};
  const bool wrinkles = !f.wrinkle_state.empty();
  return {&f.C[3 * point],
          &f.S[3 * point],
          &f.cauchy_principal[2 * point],
          f.energy_density[point],
          thickness,
          f.thickness_stretch[point],
          f.status[point] == material::point_extrapolated,
          wrinkles ? static_cast<int>(f.wrinkle_state[point]) : 0,
          wrinkles ? &f.wrinkle_crest[3 * point] : no_crest,
          crossing};
}

using Components = std::array<double, 3>;

Components at_point(const ElementField& field, const FieldPoint& point) {
  Components value{};
  for (int c = 0; c < field.components; ++c) value[static_cast<size_t>(c)] = field.value(point, c);
  return value;
}

double dot(const Components& a, const Components& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Components combined(const ElementField& field, const std::vector<FieldPoint>& points) {
  Components sum{};
  for (const FieldPoint& point : points) {
    const Components value = at_point(field, point);
    const double sign = field.over == Over::line && dot(sum, value) < 0.0 ? -1.0 : 1.0;
    for (size_t c = 0; c < sum.size(); ++c)
      sum[c] = field.over == Over::largest ? std::max(sum[c], value[c]) : sum[c] + sign * value[c];
  }
  const double length = std::sqrt(dot(sum, sum));
  for (double& component : sum) {
    if (field.over == Over::mean) component /= static_cast<double>(points.size());
    if (field.over == Over::line && length > 0.0) component /= length;
  }
  return sum;
}

}  // namespace

std::vector<OutputField> declared_element_fields() {
  std::vector<OutputField> all;
  for (const ElementField& field : table)
    for (int c = 0; c < field.components; ++c)
      all.push_back({FieldPlace::element, component_name(field.name, field.components, c), field.unit, field.text});
  return all;
}

std::vector<NamedField> element_values(const Problem& problem, const element::PointFields& points, int elements,
                                       double thickness, const double* crossing) {
  const size_t count = static_cast<size_t>(elements), per = count > 0 ? points.status.size() / count : 0;
  std::vector<NamedField> all;
  std::vector<const ElementField*> of;
  for (const ElementField& field : table) {
    if (!field.is_there(problem)) continue;
    of.push_back(&field);
    for (int c = 0; c < field.components; ++c)
      all.push_back({component_name(field.name, field.components, c), field.unit, std::vector<double>(count)});
  }
  std::vector<FieldPoint> of_element;
  for (size_t e = 0; e < count; ++e) {
    of_element.clear();
    for (size_t q = 0; q < per; ++q)
      of_element.push_back(fabric_point(points, e * per + q, thickness, crossing != nullptr ? crossing[e] : 0.0));
    auto out = all.begin();
    for (const ElementField* field : of) {
      const Components value = combined(*field, of_element);
      for (int c = 0; c < field->components; ++c) (out++)->values[e] = value[static_cast<size_t>(c)];
    }
  }
  return all;
}

}  // namespace toile::solve
