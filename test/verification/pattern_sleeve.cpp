#include "verification/pattern_sleeve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "toile/body/analytic.hpp"
#include "toile/material/relaxed_response.hpp"
#include "toile/solve/stage_kind.hpp"

namespace toile::test {
namespace {

constexpr double a = 80.0, b = 50.0;  // semi-axes of the elliptic cylinder, mm

/// Parameter of the ellipse at a part of its girth.
class EllipseByArc {
 public:
  EllipseByArc() {
    for (int i = 0; i < steps; ++i) {
      const double t = 2.0 * M_PI * (i + 0.5) / steps;
      length_.push_back(length_.back() + 2.0 * M_PI / steps * std::hypot(a * std::sin(t), b * std::cos(t)));
    }
  }
  double parameter(double part) const {
    const double wanted = part * length_.back();
    const auto next = std::clamp<std::ptrdiff_t>(
        std::upper_bound(length_.begin(), length_.end(), wanted) - length_.begin(), 1, steps);
    return 2.0 * M_PI / steps *
           (static_cast<double>(next - 1) + (wanted - length_[next - 1]) / (length_[next] - length_[next - 1]));
  }

 private:
  static constexpr int steps = 20000;
  std::vector<double> length_ = {0.0};
};

std::shared_ptr<const body::Surface> surface_of(const ContactReference& reference) {
  const std::string name = reference.part(1);
  if (name == "cyl") return body::revolution(body::linear_profile(60.0, 0.0), {}, name);
  if (name == "ellipse") return body::elliptic_cylinder(a, b, {});
  if (name == "ellipsoid") return body::ellipsoid(80.0, 120.0);
  if (name == "sphere") return body::ellipsoid(80.0, 80.0);
  if (name == "waist") return body::revolution(body::cosine_profile(60.0, -15.0, 240.0), {}, name);
  throw std::runtime_error("no body for " + name);
}

std::unique_ptr<material::Material> fabric_of(const std::string& short_name, const PatternOptions& options) {
  const material::LawV1& law = *material::find(material_of(short_name));
  const auto set = std::find_if(law.sets, law.sets + law.n_sets,
                                [](const material::ParamSet& s) { return std::string(s.name) == "pantyhose"; });
  std::vector<double> params(set->values, set->values + law.n_params);
  if (options.shell_c10 > 0.0) params = {options.shell_c10};
  std::shared_ptr<const material::Response> response;
  if (options.tension_field)
    response = std::make_shared<material::RelaxedResponse>(law, material::Relaxation::tension_field, 1e-6);
  return std::make_unique<material::Material>(law, params, 1.0, response);
}

bool is_waist(const ContactReference& reference) {
  return reference.part(1) == "waist";
}

}  // namespace

double pattern_width(const ContactReference& reference) {
  return 2.0 * M_PI * reference.header("R0");
}

double pattern_height(const ContactReference& reference) {
  if (is_waist(reference)) return reference.header("half-length");
  return reference.part(1) == "ellipse" ? 100.0 : reference.header("L0");
}

PatternSleeve::PatternSleeve(const ContactReference& reference, const PatternMesh& flat, const PatternOptions& options)
    : reference_(reference),
      options_(options),
      width_(pattern_width(reference)),
      height_(pattern_height(reference)),
      surface_(options.surface ? options.surface : surface_of(reference)),
      material_(fabric_of(reference.part(is_waist(reference) ? 2 : 3), options)) {
  mesh_.pattern.assign(flat.nodes.begin(), flat.nodes.end());
  mesh_.panels.push_back({"sleeve", 0, mesh_.nodes(), 0, {}});
  std::vector<int> four, three;
  for (const auto& e : flat.quadrilaterals) four.insert(four.end(), e.begin(), e.end());
  for (const auto& e : flat.triangles) three.insert(three.end(), e.begin(), e.end());
  if (!four.empty()) add_block("quadrilaterals", 4, four);
  if (!three.empty()) add_block("triangles", 3, three);
  problem.mesh = &mesh_;
  problem.surface = surface_.get();
  problem.contact.offset_by_half_thickness = options.shell_c10 > 0.0;  // membrane theory: at the mid-surface
  problem.contact.relative_stiffness = 10.0;
  place();
  add_clusters(flat);
  add_supports();
}

void PatternSleeve::add_block(const std::string& name, int nodes, const std::vector<int>& connectivity) {
  mesh::Block block;
  block.name = name;
  block.nodes_per_element = nodes;
  block.connectivity = connectivity;
  block.wale_angle.assign(static_cast<size_t>(block.size()), 0.5 * M_PI);
  block.position.assign(static_cast<size_t>(block.size()), 0.5);
  problem.element_rank.emplace_back(static_cast<size_t>(block.size()), 0);
  const std::string kind = options_.shell_c10 > 0.0 ? "shell" : "membrane";
  problem.models.push_back(
      {element::find(kind + std::to_string(nodes)), material_.get(), {3, 2.0 * options_.shell_c10 * 5.0 / 6.0, false}});
  mesh_.blocks.push_back(block);
}

void PatternSleeve::add_clusters(const PatternMesh& flat) {
  std::vector<int> cluster(flat.nodes.size(), -1);
  for (size_t n = 0; n < flat.nodes.size(); ++n) {
    const auto master = static_cast<size_t>(flat.tied_to[n]);
    if (master == n) {
      cluster[n] = static_cast<int>(problem.clusters.size());
      problem.clusters.emplace_back();
    }
    problem.clusters[static_cast<size_t>(cluster[master])].push_back(static_cast<int>(n));
  }
  problem.cluster_rank.assign(problem.clusters.size(), 0);
}

void PatternSleeve::add_supports() {
  solve::Support bottom{"bottom", {}, {false, false, true}, solve::Vec3::Zero()};
  solve::Support top = bottom;
  top.name = "top";
  for (size_t n = 0; n < mesh_.pattern.size(); ++n) {
    if (mesh_.pattern[n].y() < 1e-6) bottom.nodes.push_back(static_cast<int>(n));
    if (mesh_.pattern[n].y() > height_ - 1e-6) top.nodes.push_back(static_cast<int>(n));
  }
  problem.supports.push_back(bottom);
  if (reference_.part(2) == "free" && options_.top == 0.0) return;
  // Held along z alone, tension would pull the end off a body that narrows.
  if (reference_.part(1) == "ellipsoid" || is_waist(reference_)) top.held = {true, true, true};
  problem.supports.push_back(top);
}

void PatternSleeve::place() {
  const std::string body = reference_.part(1);
  const EllipseByArc ellipse;
  const double top = body == "ellipse" ? reference_.header("lam_axial") * height_
                                       : reference_.header(is_waist(reference_) ? "z" : "z_end");
  const double end = options_.top > 0.0 ? options_.top : top;
  for (const Eigen::Vector2d& X : mesh_.pattern) {
    const double part = X.x() / width_, z = end * X.y() / height_;
    if (body == "ellipse") {
      const double t = ellipse.parameter(part - std::floor(part));
      mesh_.placed.emplace_back(a * std::cos(t), b * std::sin(t), z);
    } else {
      double radius = 60.0;
      if (body == "ellipsoid") radius = 80.0 * std::sqrt(1.0 - z * z / (120.0 * 120.0));
      if (body == "sphere") radius = 80.0 * std::sqrt(1.0 - z * z / (80.0 * 80.0));
      if (body == "waist") radius = 60.0 - 15.0 * std::cos(2.0 * M_PI * z / 240.0);
      mesh_.placed.emplace_back(radius * std::cos(2.0 * M_PI * part), radius * std::sin(2.0 * M_PI * part), z);
    }
    mesh_.normal.emplace_back(surface_->closest(mesh_.placed.back()).normal);
  }
}

void PatternSleeve::settle() {
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  solve::SolverOptions options;
  solve::Simulation simulation(problem, options);
  simulation.observe([this](const solve::StepReport& r, const solve::State&) { report = r; });
  solve::State start = solve::placed_state(problem);
  start.seam = 1.0;
  simulation.set_start(start);
  solve::StageOptions stage;
  stage.name = "settle";
  stage.kind = &solve::stage_kind("settle");
  const auto begin = Clock::now();
  simulation.run(stage);
  iteration_seconds = since(begin) / simulation.statistics().newton_iterations;
  const auto solved = Clock::now();
  fields = solve::compute_fields(problem, simulation.state());
  recovery_seconds = since(solved);
}

double PatternSleeve::exact(size_t node) const {
  const solve::Vec3& x = fields.position[node];
  if (reference_.part(1) == "ellipse")
    return reference_.at("theta_param", std::atan2(std::abs(x.y()) / b, std::abs(x.x()) / a), "p");
  if (is_waist(reference_) && x.z() < reference_.header("z_d")) return 0.0;
  return reference_.at("z", x.z(), "p");
}

double PatternSleeve::from_end(size_t node) const {
  const double y = mesh_.pattern[node].y();
  return std::min(y, height_ - y);
}

}  // namespace toile::test
