#include "summary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

#include "toile/base/units.hpp"
#include "toile/material/response.hpp"
#include "toile/solve/output_fields.hpp"

namespace toile::app {

namespace {

constexpr double noise = 1e-8;  // of the largest stress or of all forces: what equilibria leave as round-off

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& n : names) all += (all.empty() ? "" : ", ") + n;
  return all.empty() ? "none" : all;
}

/// Components that are round-off beside the forces that meet in the garment are zero.
std::string vector_text(const solve::Vec3& v, double magnitude) {
  const auto shown = [&](double component) { return std::abs(component) > noise * magnitude ? component : 0.0; };
  std::ostringstream out;
  out.precision(6);
  out << "(" << shown(v[0]) << ", " << shown(v[1]) << ", " << shown(v[2]) << ") N";
  return out.str();
}

std::string stability(int negative_pivots) {
  if (negative_pivots < 0) return "stability not known (the tangent could not be factorised)";
  if (negative_pivots == 0) return "stable (no negative pivot)";
  return std::to_string(negative_pivots) + " negative pivots: unstable";
}

/// What compression in the fabric means.
std::string compression_text(const material::Response& fabric) {
  if (fabric.compression() == "tension field") return "what the residual stiffness of wrinkled fabric leaves";
  if (fabric.compression() == "slack fibres") return "compression that lies along no yarn; real fabric wrinkles there";
  return "compression: real fabric wrinkles there";
}

/// One line a panel whose fabric wrinkles: its model, and how much of it does.
std::string wrinkles_text(const solve::Problem& problem, const solve::Fields& fields) {
  std::ostringstream out;
  out.precision(3);
  for (size_t b = 0; b < problem.laws.size(); ++b) {
    const material::Response& fabric = problem.laws[b].material->response();
    if (!fabric.relaxes()) continue;
    const std::array<double, 3>& share = fields.wrinkle_shares[b];
    out << "  panel \"" << problem.mesh->blocks[b].name << "\": " << fabric.compression() << ", residual stiffness "
        << fabric.residual_stiffness() << " of that of undeformed fabric; of its area " << 100.0 * share[0]
        << " % taut, " << 100.0 * share[1] << " % wrinkled, " << 100.0 * share[2] << " % slack\n";
  }
  return out.str();
}

/// The torque of a support that turns.
std::string torque_text(const solve::Support& support, double load, double torque) {
  if (!support.turn) return "";
  const solve::Vec3& axis = support.turn->axis;
  std::ostringstream out;
  out.precision(6);
  out << ", turned by " << support.path.share(load) * support.turn->angle * 180.0 / M_PI << " deg with a torque of "
      << torque << " N mm about (" << axis[0] << ", " << axis[1] << ", " << axis[2] << ")";
  return out.str();
}

}  // namespace

Figures figures_of(const solve::Fields& fields, const solve::StepReport& report) {
  Figures f;
  f.smallest_pressure = std::numeric_limits<double>::infinity();
  for (const double p : fields.pressure) {
    f.largest_pressure = std::max(f.largest_pressure, base::mpa_to_kpa(p));
    if (p > 0.0) f.smallest_pressure = std::min(f.smallest_pressure, base::mpa_to_kpa(p));
  }
  if (f.largest_pressure == 0.0) f.smallest_pressure = 0.0;
  double largest_stress = 0.0;
  for (const double stress : solve::named(solve::element_fields(fields), "cauchy_major").values)
    largest_stress = std::max(largest_stress, std::abs(stress));
  if (std::abs(fields.smallest_principal_stress) > noise * largest_stress)
    f.smallest_stress = base::mpa_to_kpa(fields.smallest_principal_stress);
  solve::ForceBalance written = report.balance;
  written.contact = solve::contact_resultant(fields);
  f.force_balance = written.magnitude > 0.0 ? written.sum().norm() / written.magnitude : 0.0;
  f.largest_gap = report.gap;
  f.dissipation_ratio = report.dissipation_ratio;
  f.extrapolated = report.extrapolated;
  return f;
}

namespace {

/// Contact lets no free node into the body, so those that are inside are held there. Empty: there are none.
std::string held_inside(const scene::Scene& scene, const solve::Fields& fields) {
  constexpr double counts = 0.01;  // mm
  double deepest = counts;
  std::string name;
  std::set<int> inside;
  if (scene.surface() == nullptr) return "";
  for (const solve::Support& support : scene.problem().supports)
    for (const int n : support.nodes) {
      if (!(fields.gap[n] < -counts)) continue;
      inside.insert(n);
      if (-fields.gap[n] <= deepest) continue;
      deepest = -fields.gap[n];
      name = support.name;
    }
  if (inside.empty()) return "";
  std::ostringstream text;
  text.precision(3);
  text << "supports hold " << inside.size() << " nodes inside the body, up to " << deepest << " mm (support \"" << name
       << "\"): the fabric steps over the body's surface beside them, and its pressure there is that of the step. "
          "The inner face counts, half a thickness inside the mid-surface: place the panel with an \"offset\", or let "
          "the support leave the direction of the body's normal free";
  return text.str();
}

}  // namespace

std::vector<std::string> field_warnings(const scene::Scene& scene, const solve::Fields& fields,
                                        const solve::StepReport& report) {
  std::vector<std::string> warnings;
  if (const std::string inside = held_inside(scene, fields); !inside.empty()) warnings.push_back(inside);
  if (report.extrapolated > 0) {
    std::ostringstream text;
    text << "outside the calibrated range of the fabric: " << report.extrapolated << " elements, largest fibre stretch "
         << fields.largest_extrapolation << " in " << fields.extrapolated_where;
    warnings.push_back(text.str());
  }
  if (fields.isolated_contacts > 0)
    warnings.push_back(std::to_string(fields.isolated_contacts) +
                       " nodes touch the body while all their neighbours are free: the mesh is too coarse there, and "
                       "their pressure is as uncertain as it is large (field pressure_error)");
  if (fields.contacts_off_surface > 0)
    warnings.push_back("the body has no smooth surface near " + std::to_string(fields.contacts_off_surface) +
                       " nodes in contact: their pressure shows its facets");
  return warnings;
}

std::string summary(const scene::Scene& scene, const solve::Fields& fields, const solve::StepReport& report,
                    const solve::SolveStatistics& statistics, const base::Timer& timer) {
  const Figures f = figures_of(fields, report);
  std::ostringstream out;
  out.precision(6);
  out << "Summary\n  garment: " << scene.garment().mesh.nodes() << " nodes, " << scene.garment().mesh.elements()
      << " elements, " << statistics.unknowns << " unknowns (" << statistics.contact_nodes
      << " of them contact multipliers)\n";
  if (scene.surface() != nullptr) {
    out << "  body: " << scene.surface()->summary() << "\n  pressure: " << f.smallest_pressure << " to "
        << f.largest_pressure << " kPa (" << base::kpa_to_mmhg(f.smallest_pressure) << " to "
        << base::kpa_to_mmhg(f.largest_pressure)
        << " mmHg) where the garment touches\n  largest gap of a node in contact: " << f.largest_gap << " mm\n";
  }
  const material::Response& fabric = scene.problem().laws[fields.smallest_stress_block].material->response();
  out << "  smallest principal stress: " << f.smallest_stress << " kPa"
      << (f.smallest_stress < 0.0 ? " (" + compression_text(fabric) + ")" : "") << "\n";
  out << wrinkles_text(scene.problem(), fields);
  out << "  forces on the garment:";
  if (scene.surface() != nullptr)
    out << "\n    body " << vector_text(solve::contact_resultant(fields), report.balance.magnitude);
  for (size_t s = 0; s < report.balance.support.size(); ++s)
    out << "\n    support \"" << scene.problem().supports[s].name << "\" "
        << vector_text(report.balance.support[s], report.balance.magnitude)
        << torque_text(scene.problem().supports[s], report.load, report.balance.torque[s]);
  out << "\n    loads " << vector_text(report.balance.load, report.balance.magnitude) << "\n    damping "
      << vector_text(report.balance.damping, report.balance.magnitude) << "\n    held against null motions "
      << vector_text(report.balance.pins, report.balance.magnitude) << "\n    sum over magnitudes: " << f.force_balance
      << "\n";
  out << "  strain energy: " << report.strain_energy << " N mm, dissipated by damping: " << report.dissipated
      << " N mm (ratio " << f.dissipation_ratio << ")\n";
  if (report.stabilisation_energy != 0.0)
    out << "  of it in hourglass modes of reduced shells: "
        << 100.0 * report.stabilisation_energy / report.strain_energy << " %\n";
  out << "  equilibrium: relative residual " << report.residual << ", " << stability(report.negative_pivots) << "\n";
  out << "  work: " << statistics.steps << " steps, " << statistics.cut_backs << " cut-backs, "
      << statistics.newton_iterations << " Newton iterations, " << statistics.linear_iterations
      << " linear iterations, " << statistics.factorisations << " factorisations\n";
  out << "  modules used: " << joined(scene.used()) << "\n  modules left out: " << joined(scene.left_out()) << "\n";
  out << timer.table();
  return out.str();
}

}  // namespace toile::app
