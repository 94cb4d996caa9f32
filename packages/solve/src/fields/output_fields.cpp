#include "toile/solve/output_fields.hpp"

#include <algorithm>
#include <cctype>

#include "fields/element_fields.hpp"
#include "fields/field_names.hpp"
#include "toile/base/error.hpp"
#include "toile/base/units.hpp"

namespace toile::solve {

namespace {

struct NodalField {
  const char* name;
  const char* unit;
  const char* text;
  double (*value)(const Fields& fields, size_t node, int component);
  bool of_contact = true;  ///< there only with a body
  bool on_body = false;    ///< also mapped onto the body's nodes
  int components = 1;
};

struct GlobalField {
  const char* name;
  const char* unit;
  const char* text;
  double (*value)(const StepReport& report);
};

/// One value a support of a kind; the support's name follows that of the field.
struct SupportField {
  const char* name;
  const char* unit;
  const char* text;
  bool (*applies)(const Support& support);
  double (*value)(const StepReport& report, size_t support);
};

// One entry a field: what is written, described and documented comes from these tables.
const NodalField nodal_table[] = {
    {"pressure", "kPa",
     "contact pressure, recovered from the fabric's tension and the body's curvature; on the body's nodes the same, "
     "mapped onto it",
     [](const Fields& f, size_t n, int) { return base::mpa_to_kpa(f.pressure[n]); }, true, true},
    {"pressure_error", "kPa",
     "estimate of the pressure's error by mesh, body, gap, solver, damping and slack fabric; not of the fabric's model",
     [](const Fields& f, size_t n, int) { return base::mpa_to_kpa(f.pressure_error[n]); }, true, true},
    {"pressure_error_mesh", "kPa", "its part by the size of the elements",
     [](const Fields& f, size_t n, int) { return base::mpa_to_kpa(f.errors.mesh[n]); }},
    {"pressure_error_body", "kPa", "its part by the shape of a body from a file: scan noise and smoothing",
     [](const Fields& f, size_t n, int) { return base::mpa_to_kpa(f.errors.body[n]); }},
    {"contact_force", "N", "force of the body on the garment along the normal; nodes of a seam share theirs by area",
     [](const Fields& f, size_t n, int) { return f.contact_force[n]; }},
    {"gap", "mm", "distance of the fabric's contact surface from the body",
     [](const Fields& f, size_t n, int) { return f.gap[n]; }},
    {"normal", "", "outward normal of the body at the closest point",
     [](const Fields& f, size_t n, int d) { return f.normal[n][d]; }, true, false, 3},
    {"area", "mm^2", "current area that belongs to the node", [](const Fields& f, size_t n, int) { return f.area[n]; },
     false},
};

const GlobalField global_table[] = {
    {"load", "", "0 to 1", [](const StepReport& r) { return r.load; }},
    {"seam_closing", "", "0 to 1", [](const StepReport& r) { return r.seam; }},
    {"strain_energy", "N mm", "stored", [](const StepReport& r) { return r.energy.strain; }},
    {"stabilisation_energy", "N mm", "part of it that only holds the hourglass modes of reduced shells",
     [](const StepReport& r) { return r.energy.stabilisation; }},
    {"dissipated_energy", "N mm", "lost to artificial damping so far",
     [](const StepReport& r) { return r.energy.dissipated; }},
    {"dissipation_ratio", "", "dissipated over the largest strain energy",
     [](const StepReport& r) { return r.energy.dissipation_ratio; }},
    {"iterations", "", "of the step", [](const StepReport& r) { return static_cast<double>(r.iterations); }},
    {"cut_backs", "", "of the step", [](const StepReport& r) { return static_cast<double>(r.cut_backs); }},
    {"residual", "", "force residual over the forces that meet in it",
     [](const StepReport& r) { return r.accuracy.residual; }},
    {"undamped_residual", "", "the same without the damping force: how far a damped step is from equilibrium",
     [](const StepReport& r) { return r.accuracy.undamped_residual; }},
    {"kept_residual", "", "of a stage's end: what the residual stiffness of slack fabric carries, over the same forces",
     [](const StepReport& r) { return r.accuracy.kept; }},
    {"largest_gap", "mm", "of a node in contact", [](const StepReport& r) { return r.accuracy.gap; }},
    {"negative_pivots", "", "of the tangent: 0 stable; -1 not known",
     [](const StepReport& r) { return static_cast<double>(r.negative_pivots); }},
    {"condition", "", "condition number of the tangent; 0: not asked for, not known",
     [](const StepReport& r) { return r.condition; }},
    {"critical_point", "",
     "between this step and the one before: 1 a limit point, 2 a bifurcation, 3 one of them or a change of contact "
     "(natural continuation cannot tell), 4 a jump to another branch",
     [](const StepReport& r) { return static_cast<double>(r.critical); }},
    {"undamped", "", "1: the final state of a stage", [](const StepReport& r) { return r.undamped ? 1.0 : 0.0; }},
    {"wall_time", "s", "since the start", [](const StepReport& r) { return r.seconds; }},
};

const SupportField support_table[] = {
    {"torque_", "N mm",
     "of a support that turns: its moment on the garment about its axis; signs other than letters and digits in its "
     "name become _",
     [](const Support& s) { return s.turn.has_value(); },
     [](const StepReport& r, size_t s) { return r.balance.torque[s]; }},
};

/// A name that every reader of Exodus and HDF5 takes.
std::string plain(std::string name) {
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

}  // namespace

std::vector<OutputField> output_fields() {
  std::vector<OutputField> all;
  for (const NodalField& field : nodal_table)
    for (int c = 0; c < field.components; ++c)
      all.push_back({FieldPlace::node, component_name(field.name, field.components, c), field.unit, field.text});
  const std::vector<OutputField> of_elements = declared_element_fields();
  all.insert(all.end(), of_elements.begin(), of_elements.end());
  for (const GlobalField& field : global_table) all.push_back({FieldPlace::global, field.name, field.unit, field.text});
  for (const SupportField& field : support_table)
    all.push_back({FieldPlace::global, std::string(field.name) + "<support>", field.unit, field.text});
  return all;
}

std::vector<NamedField> nodal_fields(const Problem& problem, const Fields& fields) {
  std::vector<NamedField> all;
  for (const NodalField& field : nodal_table) {
    if (field.of_contact && problem.surface == nullptr) continue;
    for (int c = 0; c < field.components; ++c) {
      NamedField named{component_name(field.name, field.components, c), field.unit, {}, field.on_body};
      for (size_t n = 0; n < fields.position.size(); ++n) named.values.push_back(field.value(fields, n, c));
      all.push_back(std::move(named));
    }
  }
  return all;
}

std::vector<NamedField> element_fields(const Fields& fields) {
  std::vector<NamedField> all = fields.element.at(0);
  for (size_t block = 1; block < fields.element.size(); ++block)
    for (size_t f = 0; f < all.size(); ++f) {
      const std::vector<double>& more = fields.element[block][f].values;
      all[f].values.insert(all[f].values.end(), more.begin(), more.end());
    }
  return all;
}

std::vector<std::string> field_names_of(const Support& support) {
  std::vector<std::string> names;
  for (const SupportField& field : support_table)
    if (field.applies(support)) names.push_back(field.name + plain(support.name));
  return names;
}

std::vector<NamedField> global_fields(const Problem& problem, const StepReport& report) {
  std::vector<NamedField> all;
  for (const GlobalField& field : global_table) all.push_back({field.name, field.unit, {field.value(report)}});
  for (const SupportField& field : support_table)
    for (size_t s = 0; s < problem.supports.size(); ++s)
      if (field.applies(problem.supports[s]))
        all.push_back({field.name + plain(problem.supports[s].name), field.unit, {field.value(report, s)}});
  return all;
}

const NamedField& named(const std::vector<NamedField>& fields, const std::string& name) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const NamedField& f) { return f.name == name; });
  if (found == fields.end()) throw base::Error(base::ExitCode::internal_error, "no field is named \"" + name + "\"");
  return *found;
}

NamedField named(std::vector<NamedField>&& fields, const std::string& name) {
  return named(static_cast<const std::vector<NamedField>&>(fields), name);
}

}  // namespace toile::solve
