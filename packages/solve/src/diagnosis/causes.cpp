// Why a stage fails, as far as the state that it failed in tells.
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "diagnosis/diagnosis.hpp"
#include "diagnosis/fabric_state.hpp"
#include "diagnosis/law_floor.hpp"
#include "diagnosis/place.hpp"
#include "toile/solve/connected_parts.hpp"
#include "toile/solve/loss_of_ellipticity.hpp"
#include "toile/solve/stage_kind.hpp"

namespace toile::solve {

namespace {

/// Two nodes that a seam ties although the body is between them.
std::string seam_through_body(const Failure& failure) {
  const Problem& problem = failure.problem;
  if (problem.surface == nullptr || !failure.stage.kind->closes_seams() || failure.start.seam >= 1.0) return {};
  constexpr double inside = 0.2;    // of the way: a chord across a gap of a seam lies much less deep
  constexpr double touching = 1.0;  // mm: edges that meet already have no way to go
  double deepest = 0.0, apart = 0.0;
  size_t worst = 0;
  for (size_t c = 0; c < problem.clusters.size(); ++c)
    for (size_t k = 1; k < problem.clusters[c].size(); ++k) {
      const Vec3 a = problem.mesh->placed[problem.clusters[c].front()],
                 b = problem.mesh->placed[problem.clusters[c][k]];
      const double depth = -problem.surface->closest(0.5 * (a + b)).gap;
      if ((b - a).norm() < touching || depth <= std::max(deepest, inside * (b - a).norm())) continue;
      deepest = depth;
      apart = (b - a).norm();
      worst = c;
    }
  if (deepest == 0.0) return {};
  return "the way that a seam closes leads through the body: " + node_text(problem, placed_state(problem), worst) +
         ", starts " + number_text(apart) +
         " mm from the node that it is sewn to, with the body between them. Check which edges the seam joins, and "
         "where "
         "the panels start";
}

/// What no garment is made for, mostly a wrong unit.
std::string starts_too_stretched(const Failure& failure) {
  constexpr double most = 4.0, least = 0.25;
  if (failure.stepped) return {};
  const FabricState fabric = fabric_state(failure.problem, failure.start);
  const FabricPoint* point = nullptr;
  if (fabric.most_stretched.found && fabric.most_stretched.stretch[0] > most) point = &fabric.most_stretched;
  if (point == nullptr && fabric.most_compressed.found && fabric.most_compressed.stretch[1] < least)
    point = &fabric.most_compressed;
  if (point == nullptr) return {};
  return "at its start the fabric is " + std::string(point == &fabric.most_stretched ? "stretched" : "compressed") +
         " further than any garment: " + point->text() +
         ". Check that pattern and body are in mm, and the size of the panel against where it is placed";
}

/// What moves one part of the garment, and into which directions no support holds it.
struct Push {
  Vec3 moved = Vec3::Zero();  ///< mean motion of the part since the start of the stage, mm
  Vec3 force = Vec3::Zero();  ///< of body and loads along directions that nothing holds, N
  double magnitude = 0.0;     ///< sum of the magnitudes of the forces, N
  double facing = 0.0;        ///< mean square of the cosine between the force and the body's normals
};

/// Part of a force along the directions that not even one node's support holds.
Vec3 part_along_free(const Eigen::Matrix3d& held_directions, const Vec3& force) {
  constexpr double less_than_a_node = 0.5;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> held(held_directions);
  Vec3 free = Vec3::Zero();
  for (Eigen::Index k = 0; k < 3; ++k)
    if (held.eigenvalues()[k] < less_than_a_node)
      free += held.eigenvectors().col(k).dot(force) * held.eigenvectors().col(k);
  return free;
}

Push push_of(const Failure& failure, const std::vector<int>& part, const std::vector<Vec3>& loads) {
  const Problem& problem = failure.problem;
  const State& state = failure.stepped ? failure.last : failure.left.state;
  Push push;
  Eigen::Matrix3d held_directions = Eigen::Matrix3d::Zero();  // sum of n n^T
  double pressed = 0.0;
  std::vector<std::pair<double, Vec3>> contacts;
  for (const int c : part) {
    for (Eigen::Index i = 0; i < 3; ++i)
      if (const HeldComponent& held = failure.held.position[c][i]; held.held && held.support >= 0) {
        const Vec3 direction = failure.held.direction(c, i);
        held_directions += direction * direction.transpose();
      }
    push.moved += (failure.left.state.position[c] - failure.start.position[c]) / static_cast<double>(part.size());
    push.force += loads[c];
    push.magnitude += loads[c].norm();
    if (state.contact_force[c] <= 0.0) continue;
    Vec3 mean = Vec3::Zero();
    for (const int n : problem.clusters[c])
      mean += node_position(problem, state, c, n) / static_cast<double>(problem.clusters[c].size());
    contacts.emplace_back(state.contact_force[c], problem.surface->closest(mean).normal);
    push.force += contacts.back().first * contacts.back().second;
    pressed += contacts.back().first;
  }
  push.magnitude += pressed;
  push.force = part_along_free(held_directions, push.force);
  const double size = push.force.norm();
  for (const auto& [force, normal] : contacts)
    if (size > 0.0) push.facing += force / pressed * std::pow(normal.dot(push.force) / size, 2);
  return push;
}

/// Diagonal of the box around the part as it is placed, mm.
double part_size(const Problem& problem, const std::vector<int>& part) {
  Eigen::AlignedBox3d box;
  for (const int c : part)
    for (const int n : problem.clusters[c]) box.extend(problem.mesh->placed[n]);
  return box.diagonal().norm();
}

std::vector<Vec3> loads_of(const Problem& problem, double load) {
  std::vector<Vec3> of_node(problem.mesh->placed.size(), Vec3::Zero()), all;
  for (const NodalLoad& force : problem.loads)
    for (size_t i = 0; i < force.nodes.size() && !force.moment; ++i)
      of_node[force.nodes[i]] += load * force.share[i] * force.value;
  for (const std::vector<int>& members : problem.clusters) {
    all.emplace_back(Vec3::Zero());
    for (const int n : members) all.back() += of_node[n];
  }
  return all;
}

/// Fabric that is compressed more than stretched has no shape as a membrane.
std::string is_loose(const Failure& failure) {
  constexpr double unstretched = 1e-3;
  const Problem& problem = failure.problem;
  if (problem.surface == nullptr) return {};
  const FabricState fabric = fabric_state(problem, failure.stepped ? failure.last : failure.start);
  if (fabric.without_energy > 0 || !fabric.most_compressed.found) return {};
  const bool slack = fabric.most_stretched.stretch[0] < 1.0 + unstretched;
  if (!slack && fabric.tension > fabric.compression) return {};
  std::string text = "the garment is loose, wider than the body where it is: ";
  if (slack && fabric.most_compressed.stretch[1] > 1.0 - unstretched)
    text += "its fabric is not stretched anywhere";
  else
    text += "its fabric is compressed more than it is stretched, most in " + fabric.most_compressed.text();
  return text +
         ". So it presses nowhere, and membranes without tension have no shape of their own. Make the pattern "
         "narrower, or give the fabric \"compression\" = \"tension field\", which carries no compression";
}

/// Without a body a flat membrane without tension can be moved across itself by nothing.
std::string has_no_tension(const Failure& failure) {
  constexpr double unstretched = 1e-3;
  if (failure.problem.surface != nullptr || failure.stepped) return {};
  const auto is_membrane = [](const BlockModel& model) { return !model.is_shell(); };
  const std::vector<BlockModel>& models = failure.problem.models;
  if (std::none_of(models.begin(), models.end(), is_membrane)) return {};
  const FabricState fabric = fabric_state(failure.problem, failure.start);
  if (!fabric.most_stretched.found || fabric.most_stretched.stretch[0] > 1.0 + unstretched) return {};
  return std::string(
             "at its start the fabric carries no tension, and without tension a membrane has no stiffness across "
             "itself. "
             "Stretch it a little by its supports before it is loaded, or give the panel a list \"Shell\"") +
         (failure.stage.damping.active ? "" : ", or the stage a list \"Damping\"");
}

std::string loses_ellipticity(const Failure& failure) {
  if (failure.stepped) {
    const LossOfEllipticity loss = find_loss_of_ellipticity(failure.problem, failure.last);
    if (loss.found()) return "In the last converged state " + loss.text();
  }
  if (!failure.left.finite) return {};
  const LossOfEllipticity loss = find_loss_of_ellipticity(failure.problem, failure.left.state);
  return loss.found() ? "Where the last attempt gave up, " + loss.text() : std::string();
}

/// The residual fell all the way to the last allowed iteration.
std::string still_converging(const Failure& failure) {
  const std::vector<double>& residual = failure.left.residual;
  constexpr size_t looked_at = 4;
  if (failure.left.iterations < failure.newton.max_iterations || residual.size() < looked_at) return {};
  for (size_t k = residual.size() - looked_at + 1; k < residual.size(); ++k)
    if (!(residual[k] < 0.5 * residual[k - 1])) return {};
  return "the iteration was still converging; allow it more (\"most iterations\" of the list \"Solver\", now " +
         std::to_string(failure.newton.max_iterations) + ")";
}

std::string reaches_the_floor(const Failure& failure) {
  return failure.stepped ? law_floor_text(failure.problem, failure.last) : std::string();
}

/// The load stands still while the steps shrink to the smallest.
std::string reaches_a_limit(const Failure& failure) {
  constexpr double shrunk = 4.0;  // times the smallest step
  const StageOptions& stage = failure.stage;
  if (!stage.kind->changes_load() || stage.arc_length || !failure.stepped || failure.relaxing) return {};
  if (failure.left.s - failure.reached > shrunk * stage.smallest_step) return {};
  const Problem& problem = failure.problem;
  std::string text =
      "beyond load " + number_text(failure.last.load) + " there may be no equilibrium: the garment cannot carry more";
  if (!problem.pressures.empty())
    text += " of the pressure \"" + problem.pressures.front().name + "\"";
  else if (!problem.loads.empty())
    text += " of the load \"" + problem.loads.front().name + "\"";
  text += " (a limit point)";
  if (problem.surface == nullptr && !stage.damping.active)
    text += ". \"continuation\" = \"arc length\" follows the path past it";
  return text;
}

std::string far_from_equilibrium(const Failure& failure) {
  constexpr double near = 1e-3;
  if (failure.left.total.relative() < near) return {};
  const FabricState fabric = fabric_state(failure.problem, failure.start);
  if (!fabric.most_compressed.found) return {};
  return "the start is far from an equilibrium. Its fabric is compressed most in " + fabric.most_compressed.text() +
         "; it is stretched most in " + fabric.most_stretched.text() +
         ". Place the panels nearer to where they will lie (\"toile check\" looks at the start without solving)";
}

std::string nothing_known(const Failure& failure) {
  const StageOptions& stage = failure.stage;
  if (stage.arc_length) return "the path may not lead to the target, or not within \"most steps\"";
  if (!failure.stepped && !failure.relaxing && stage.damping.active) return far_from_equilibrium(failure);
  if (stage.damping.active)
    return failure.stepped && !failure.relaxing
               ? "\"smallest step\" (now " + number_text(stage.smallest_step) +
                     ") may be too long for what happens there; a smaller one lets the "
                     "stage go on in shorter steps"
               : std::string();
  return failure.stepped
             ? "the garment may snap or wrinkle there, which damping carries it through: give the stage a list "
               "\"Damping\""
             : "the start is far from an equilibrium: give the stage a list \"Damping\"";
}

}  // namespace

std::string unheld_motion(const Failure& failure) {
  constexpr double noticeable = 0.01, along_the_body = 0.1, unbalanced = 0.01, far = 0.25;
  const Problem& problem = failure.problem;
  if (problem.surface == nullptr || !problem.pressures.empty() || !failure.left.finite) return {};
  // Forces that do not balance yet, or that a strong damping takes up, say nothing about what pushes the garment: only
  // how far it went does.
  const bool fading = failure.relaxing && failure.left.damping > 0.0;
  if (!failure.stepped && !fading && failure.left.total.relative() > unbalanced) return {};
  const State& state = failure.stepped ? failure.last : failure.left.state;
  const std::vector<Vec3> loads = loads_of(problem, state.load);
  for (const std::vector<int>& part : connected_parts(problem)) {
    const Push push = push_of(failure, part, loads);
    const double size = push.force.norm();
    if (size <= noticeable * push.magnitude || size == 0.0) continue;
    if (push.facing >= along_the_body && !is_loose(failure).empty()) continue;  // slack fabric presses by round-off
    const Vec3 direction = push.force / size;
    const double moved = push.moved.dot(direction);
    if (!failure.stepped && fading && moved < far * part_size(problem, part)) continue;
    std::string text = panels_of(problem, part) +
                       (push.facing < along_the_body ? ": it slides along the body" : ": it is pushed off the body") +
                       ", in the direction " + direction_text(direction);
    if (moved > 1.0) text += ", by " + number_text(moved) + " mm in this stage";
    text += ": the body pushes it there with " + number_text(size) + " N";
    if (push.facing < along_the_body)
      return text +
             ", there is no friction, and no support holds it. Hold an end of it along the limb (list \"Supports\")";
    return text +
           ", and neither a support nor fabric on the other side of the body holds it. Close it around the body by "
           "seams (is one missing?), or hold it by a support";
  }
  return {};
}

const std::vector<Cause>& causes() {
  static const std::vector<Cause> all = {reaches_the_floor, seam_through_body, starts_too_stretched, unheld_motion,
                                         is_loose,          has_no_tension,    loses_ellipticity,    still_converging,
                                         reaches_a_limit,   nothing_known};
  return all;
}

}  // namespace toile::solve
