// The summary that ends a run.
#include <array>
#include <cmath>
#include <sstream>

#include "figures.hpp"
#include "output.hpp"
#include "toile/base/memory.hpp"
#include "toile/base/units.hpp"
#include "toile/material/response.hpp"

namespace toile::run {

namespace {

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
  if (fabric.compression() == "slack fibres") return "compression that lies along no yarn; real fabric wrinkles there";
  return "compression: real fabric wrinkles there";
}

/// One line a panel whose fabric wrinkles: its model, and how much of it does.
std::string wrinkles_text(const solve::Problem& problem, const solve::Fields& fields) {
  std::ostringstream out;
  out.precision(3);
  for (size_t b = 0; b < problem.models.size(); ++b) {
    const material::Response& fabric = problem.models[b].material->response();
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

std::string text_of(const Record& record, const base::Timer& timer) {
  const scene::Scene& scene = record.scene();
  const solve::Fields& fields = record.fields();
  const solve::StepReport& report = record.last();
  const solve::SolveStatistics& statistics = record.statistics();
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
  const material::Response& fabric = scene.problem().models[fields.smallest_stress_block].material->response();
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
  out << "  strain energy: " << report.energy.strain << " N mm, dissipated by damping: " << report.energy.dissipated
      << " N mm (ratio " << f.dissipation_ratio << ")\n";
  if (report.energy.stabilisation != 0.0)
    out << "  of it in hourglass modes of reduced shells: "
        << 100.0 * report.energy.stabilisation / report.energy.strain << " %\n";
  out << "  equilibrium: relative residual " << report.accuracy.residual << ", " << stability(report.negative_pivots);
  if (report.condition > 0.0) out << ", condition number " << report.condition;
  if (report.accuracy.kept > 0.0) out << "; the residual stiffness of slack fabric carries " << report.accuracy.kept;
  out << "\n";
  out << "  work: " << statistics.steps << " steps, " << statistics.cut_backs << " cut-backs, "
      << statistics.newton_iterations << " Newton iterations, " << statistics.linear_iterations
      << " linear iterations, " << statistics.factorisations << " factorisations\n";
  out << "  memory: " << std::lround(base::peak_memory()) << " MB at most, on the first rank\n";
  out << "  modules used: " << joined(scene.used()) << "\n  modules left out: " << joined(scene.left_out()) << "\n";
  out << timer.table();
  return out.str();
}

class Summary : public Observer {
 public:
  Summary(base::Log& log, const base::Timer& timer) : log_(log), timer_(timer) {}

  void end(const Record& record) override { log_.info(text_of(record, timer_)); }

 private:
  base::Log& log_;
  const base::Timer& timer_;
};

}  // namespace

Output summary_output() {
  return {{}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            return std::make_unique<Summary>(context.log, context.timer);
          }};
}

}  // namespace toile::run
