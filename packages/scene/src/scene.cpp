#include "toile/scene/scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "check_nodes.hpp"
#include "drape_fault.hpp"
#include "read_output.hpp"
#include "toile/base/error.hpp"
#include "toile/body/body.hpp"
#include "toile/crossing/crossings.hpp"
#include "toile/drape/drape.hpp"
#include "toile/element/element.hpp"
#include "toile/mesh/partition.hpp"
#include "toile/solve/spec.hpp"
#include "toile/solve/stage_kind.hpp"

namespace toile::scene {

namespace {

std::optional<base::List> optional_list(const base::List& list, const std::string& name) {
  if (!list.has_list(name)) return std::nullopt;
  return list.list(name);
}

base::List entry_of(const base::List& list, const std::string& name) {
  const std::vector<base::List> entries = list.entries();
  return *std::find_if(entries.begin(), entries.end(), [&](const base::List& entry) { return entry.name() == name; });
}

solve::ShellModel section(const garment::ShellOptions& shell, const material::Material& fabric) {
  const double modulus = shell.shear_modulus ? *shell.shear_modulus
                                             : fabric.response().natural_shear_modulus(fabric.params_at(0.0).data());
  return {shell.layers, shell.shear_correction * modulus, shell.placed_is_stress_free};
}

[[noreturn]] void fail_sewing(const base::List& stages) {
  for (const base::List& stage : stages.entries())
    if (stage.word("type") == "sew")
      stage.fail("type",
                 "the scene has no list \"Seams\" with a seam to sew. Without seams, use a stage of type settle");
  throw base::Error(base::ExitCode::internal_error, "no stage sews");
}

double length_of(const base::Reals& vector) {
  double squares = 0.0;
  for (const double component : vector) squares += component * component;
  return std::sqrt(squares);
}

bool is_along(const base::Reals& vector, const body::Vec3& direction) {
  if (vector.size() != 3) return false;
  const body::Vec3 v(vector[0], vector[1], vector[2]);
  return v.cross(direction).norm() <= 1e-6 * v.norm();
}

/// Where the garment can reach; empty where that is not known. What supports move is added to it.
std::optional<body::Region> reach_of_moved_garment(const base::List& list) {
  std::optional<body::Region> reach = garment::reach_of(list.list("Panels"));
  if (!reach || !list.has_list("Supports")) return reach;
  double largest = 0.0;  // mm
  for (const base::List& support : list.list("Supports").entries()) {
    largest = std::max(largest, length_of(support.reals("move by")));
    // Turned about the region's own direction the garment keeps its heights; otherwise it may get anywhere.
    if (support.given("turn by") && !is_along(support.reals("axis direction"), reach->direction)) return std::nullopt;
  }
  reach->margin += largest;
  return reach;
}

}  // namespace

Scene::Scene(const base::List& list, int ranks, base::Timer& timer, const material::Laws& laws)
    : title_(list.word("title")) {
  // A body takes the longest to read; what does not need it is checked before.
  read_materials(list, laws);
  read_stages(list);
  if (const auto solver = optional_list(list, "Solver")) solver_ = solve::read_solver(*solver);
  const auto output = optional_list(list, "Output");
  if (output) output_ = read_output(list);
  checks_ = read_checks(list, output_);
  if (list.has_list("Accuracy")) accuracy_ = read_accuracy(list);
  garment::CutGarment cut = cut_garment(list, timer);
  {
    const auto phase = timer.phase("body");
    if (const auto body = optional_list(list, "Body")) {
      const auto reach = reach_of_moved_garment(list);
      surface_ = body::make_surface(*body, reach ? &*reach : nullptr, &body_);
    }
  }
  {
    const auto phase = timer.phase("garment");
    garment_ = garment::place_garment(std::move(cut), list.list("Panels"), surface_.get());
  }
  if (const auto drape = optional_list(list, "Drape")) {
    const auto phase = timer.phase("drape");
    drape_garment(list, *drape);
  }
  build_models(list);
  {
    const auto phase = timer.phase("partition");
    build_problem(list, ranks);
  }
  try {
    if (output) find_places(*output, problem_, output_);
  } catch (const base::InputError& error) {
    // A pattern of another size has its points elsewhere, and is the reason to be told first.
    if (drape_fault_.empty()) throw;
    throw base::InputError(drape_fault_ + "\n" + error.what());
  }
  problem_.crossings = output_.crossings && crossing::available();
  list_modules(ranks);
}

void Scene::read_stages(const base::List& list) {
  const base::List stages = list.list("Stages");
  stages_ = solve::read_stages(stages);
  for (size_t k = 0; k < stages_.size(); ++k) {
    sews_ = sews_ || stages_[k].kind->closes_seams();
    damps_ = damps_ || stages_[k].damping.active;
    if (stages_[k].arc_length && list.has_list("Body"))
      stages.entries()[k].fail(
          "continuation", "must be \"natural\" in a scene with a body: what is in contact may change along a step");
  }
  solve::check_released(stages, names_of(list, "Supports"));
}

garment::CutGarment Scene::cut_garment(const base::List& list, base::Timer& timer) {
  const auto phase = timer.phase("garment");
  const auto seams = optional_list(list, "Seams");
  garment::CutGarment cut = garment::cut_garment(list.list("Panels"), seams ? &*seams : nullptr);
  const mesh::Mesh& mesh = cut.garment.mesh;
  check_nodes(list, mesh);
  if (sews_ && cut.garment.seams.empty()) fail_sewing(list.list("Stages"));
  if (const auto loads = optional_list(list, "Loads")) {
    solve::Loads read = solve::read_loads(*loads, mesh);
    problem_.loads = std::move(read.nodal);
    problem_.pressures = std::move(read.pressures);
  }
  return cut;
}

// What supports hold in a direction of space stays where it is placed; along the limb has a meaning on the body only.
std::vector<drape::Held> Scene::held_while_draped(const base::List& scene) const {
  std::vector<drape::Held> all;
  const auto list = optional_list(scene, "Supports");
  if (!list) return all;
  solve::Problem placed;
  placed.mesh = &garment_.mesh;
  placed.surface = surface_.get();
  const std::vector<base::List> entries = list->entries();
  const std::vector<solve::Support> supports = solve::read_supports(*list, placed);
  for (size_t s = 0; s < supports.size(); ++s) {
    if (entries[s].word("hold") == "along the limb") continue;
    for (size_t k = 0; k < supports[s].nodes.size(); ++k)
      for (Eigen::Index i = 0; i < 3; ++i)
        if (supports[s].held[static_cast<size_t>(i)]) all.push_back({supports[s].nodes[k], supports[s].axis(k, i)});
  }
  return all;
}

void Scene::drape_garment(const base::List& scene, const base::List& list) {
  if (surface_ == nullptr) list.fail("distance", "is from a body, and the scene has none (list \"Body\")");
  for (const std::optional<garment::ShellOptions>& shell : garment_.shells)
    if (shell && shell->placed_is_stress_free)
      list.fail("distance",
                "belongs to a drape, which stretches what is placed; a panel whose list \"Shell\" takes the "
                "placed shape as stress-free would forget that. Take the flat pattern (\"stress-free\")");
  const garment::Clusters clusters = garment::build_clusters(garment_.mesh.nodes(), garment_.seams);
  const drape::Outcome outcome =
      drape::drape(garment_.mesh, clusters.members, held_while_draped(scene), *surface_, drape::read_options(list));
  drape_fault_ = drape_fault(scene, garment_, clusters, *surface_, outcome);
}

void Scene::check_drape() const {
  if (!drape_fault_.empty()) throw base::InputError(drape_fault_);
}

void Scene::read_materials(const base::List& list, const material::Laws& laws) {
  base::Texts names;
  for (const base::List& entry : list.list("Materials").entries()) {
    names.push_back(entry.name());
    materials_[entry.name()] = std::make_unique<material::Material>(entry, laws);
  }
  const auto check_name = [&](const base::List& of) {
    if (materials_.count(of.word("material")) == 0)
      of.fail("material", "no entry of the list \"Materials\" has this name" + base::hint(of.word("material"), names));
  };
  for (const base::List& panel : list.list("Panels").entries()) {
    check_name(panel);
    if (!panel.has_list("Zones")) continue;
    for (const base::List& zone : panel.list("Zones").entries())
      if (!zone.word("material").empty()) check_name(zone);
  }
}

void Scene::build_models(const base::List& list) {
  const std::vector<base::List> panels = list.list("Panels").entries();
  for (size_t b = 0; b < garment_.mesh.blocks.size(); ++b) {
    const material::Material& fabric = *materials_.at(garment_.mesh.blocks[b].material);
    const bool quads = garment_.mesh.blocks[b].nodes_per_element == 4;
    const std::optional<garment::ShellOptions>& shell = garment_.shells[b];
    const base::List& panel = panels[static_cast<size_t>(garment_.mesh.blocks[b].panel)];
    if (shell && fabric.graduated() && !shell->shear_modulus)
      panel.list("Shell").fail("shear modulus",
                               "is not found from a graduated fabric; give it a value for the whole panel");
    if (shell && entry_of(list.list("Materials"), fabric.name()).word("compression") == "tension field")
      panel.fail("material",
                 "the fabric is a tension field (\"compression\" of \"" + fabric.name() +
                     "\"), in which fine wrinkles take up all compression: for membranes. A shell has bending "
                     "stiffness and wrinkles by itself, as wide as its thickness has it. Give the fabric "
                     "\"compression\" = \"slack fibres\" or \"full\", or leave out the list \"Shell\"");
    const char* name = !shell           ? (quads ? "membrane4" : "membrane3")
                       : !quads         ? "shell3"
                       : shell->reduced ? "shell4r"
                                        : "shell4";
    problem_.models.push_back({element::find(name), &fabric, shell ? section(*shell, fabric) : solve::ShellModel()});
  }
}

void Scene::build_problem(const base::List& list, int ranks) {
  problem_.mesh = &garment_.mesh;
  problem_.clusters = garment_.clusters.members;
  problem_.seam = garment::seam_names(garment_.clusters, garment_.seams);
  problem_.surface = surface_.get();
  problem_.beneath = garment_.beneath;
  if (surface_ == nullptr)
    for (const base::List& panel : list.list("Panels").entries())
      if (!panel.words("over").empty())
        panel.fail("over", "is for panels on a body, and the scene has no list \"Body\"");
  const auto supports = optional_list(list, "Supports");
  if (supports) {
    problem_.supports = solve::read_supports(*supports, problem_);
    check_shells_of_supports(*supports);
  }
  solve::check_supports(supports ? &*supports : nullptr, list.list("Stages"), problem_);
  if (const auto loads = optional_list(list, "Loads")) check_shells_of_moments(*loads);
  solve::find_path_targets(list.list("Stages"), problem_, stages_);
  if (const auto contact = optional_list(list, "Contact")) {
    if (surface_ == nullptr)
      throw base::InputError(contact->file() + ": " + contact->path() +
                             ": the scene has no list \"Body\" to be in contact with");
    problem_.contact = solve::read_contact(*contact);
  }
  const mesh::Partition partition = mesh::partition(garment_.mesh, garment_.clusters.of_node, ranks);
  problem_.cluster_rank = partition.cluster_rank;
  auto next = partition.element_rank.begin();
  for (const mesh::Block& block : garment_.mesh.blocks) {
    problem_.element_rank.emplace_back(next, next + block.size());
    next += block.size();
  }
}

// Membranes have no directors that a moment or a clamp could turn or hold.
bool Scene::all_shells(const std::vector<int>& nodes) const {
  const std::vector<bool> shell = solve::shell_nodes(problem_);
  return std::all_of(nodes.begin(), nodes.end(), [&](int n) { return shell[n]; });
}

void Scene::check_shells_of_moments(const base::List& loads) const {
  for (const solve::NodalLoad& load : problem_.loads)
    if (load.moment && !all_shells(load.nodes))
      entry_of(loads, load.name)
          .fail("on", "a moment turns shells only; give the panel a list \"Shell\", or load it by forces");
}

void Scene::check_shells_of_supports(const base::List& supports) const {
  constexpr double least = 0.1;  // of the normal, in the plane of symmetry or of the diaphragm
  const std::vector<std::vector<solve::Vec3>> planes = solve::symmetry_planes(problem_);
  const std::vector<solve::Frame> start = solve::start_frames(problem_);
  for (const solve::Support& support : problem_.supports) {
    if (support.director == solve::DirectorSupport::free) continue;
    if (!all_shells(support.nodes))
      entry_of(supports, support.name)
          .fail("director",
                "is for shells, and \"on\" names nodes of a membrane; give their panel a list \"Shell\", or leave "
                "\"director\" out");
    for (size_t k = 0; k < support.nodes.size(); ++k) {
      const int node = support.nodes[k];
      solve::Vec3 normal = garment_.mesh.normal[node];
      for (const solve::Vec3& plane : planes[node]) normal -= normal.dot(plane) * plane;
      if (normal.norm() < least)
        entry_of(supports, support.name)
            .fail(
                "director",
                "\"symmetry\" needs held directions that lie in the panel, and one of these is along its normal; hold "
                "that direction in a support of its own");
      if (support.director == solve::DirectorSupport::diaphragm &&
          solve::diaphragm_normal(support, k, start[node].row(2)).norm() < least)
        entry_of(supports, support.name)
            .fail("director",
                  "\"diaphragm\" needs a panel that passes through its plane, but this one lies in it; leave "
                  "\"director\" out, or make it \"held\"");
    }
  }
}

void Scene::list_modules(int ranks) {
  const auto sort = [&](bool is_used, const std::string& name) { (is_used ? used_ : left_out_).push_back(name); };
  sort(surface_ != nullptr, "body and contact");
  sort(!garment_.seams.empty(), "seams");
  sort(sews_, "sewing by continuation");
  sort(damps_, "damping");
  const bool bends =
      std::any_of(problem_.models.begin(), problem_.models.end(), [](const auto& law) { return law.is_shell(); });
  sort(bends, "shells");
  const auto relaxes = [](const auto& law) { return law.material->response().relaxes(); };
  sort(std::any_of(problem_.models.begin(), problem_.models.end(), relaxes), "relaxed fabric");
  const auto turns = [](const solve::Support& support) { return support.turn.has_value(); };
  sort(std::any_of(problem_.supports.begin(), problem_.supports.end(), turns), "turning supports");
  sort(!problem_.loads.empty(), "dead loads");
  sort(!problem_.pressures.empty(), "follower pressure");
  const auto wants = [&](const auto& option) { return std::any_of(stages_.begin(), stages_.end(), option); };
  sort(wants([](const auto& stage) { return stage.stability_every_step; }), "stability at every step");
  sort(wants([](const auto& stage) { return stage.arc_length; }), "arc length continuation");
  const bool graduated =
      std::any_of(materials_.begin(), materials_.end(), [](const auto& m) { return m.second->graduated(); });
  sort(graduated, "graduated fabric");
  sort(ranks > 1, "partition");
}

solve::State Scene::start() const {
  solve::State state = solve::placed_state(problem_);
  if (sews_) return state;
  state.seam = 1.0;
  for (size_t c = 0; c < problem_.clusters.size(); ++c) {
    state.position[c].setZero();
    for (const int n : problem_.clusters[c])
      state.position[c] += garment_.mesh.placed[n] / static_cast<double>(problem_.clusters[c].size());
  }
  return state;
}

}  // namespace toile::scene
