#include "diagnosis/diagnosis.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/fabric_state.hpp"
#include "diagnosis/place.hpp"

namespace toile::solve {

namespace {

/// Where the last attempt wanted to get.
std::string attempt_text(const Failure& failure) {
  if (failure.relaxing) return "The last attempt at its undamped end";
  if (!failure.stepped) return "The attempt at its start, before any step,";
  return "The last attempt, a step of " + number_text(failure.left.s - failure.reached) + ",";
}

/// How Newton's method ended.
std::string end_text(const Failure& failure) {
  const Remainder& left = failure.left;
  if (!left.finite) return "came to a state that has no energy";
  if (left.total.relative() <= failure.newton.tolerance && left.total.gap <= failure.newton.gap_tolerance)
    return "found an equilibrium on another branch, to which the garment would jump, and was given up";
  if (left.iterations >= failure.newton.max_iterations)
    return "was given up after " + std::to_string(left.iterations) + " iterations (\"most iterations\")";
  if (!left.factorised) return "was given up because its tangent could not be factorised";
  return "found no step that lowers the energy after " + std::to_string(left.iterations) + " iterations";
}

template <class Measure>
size_t largest(size_t count, const Measure& measure) {
  size_t worst = 0;
  for (size_t c = 1; c < count; ++c)
    if (measure(c) > measure(worst)) worst = c;
  return worst;
}

std::string energy_text(const Failure& failure) {
  const FabricState fabric = fabric_state(failure.problem, failure.left.state);
  if (fabric.without_energy == 0) return {};
  return " The fabric has no energy at " + std::to_string(fabric.without_energy) + " of " +
         std::to_string(fabric.points) + " points; worst in " + fabric.worst_without_energy.text() + ".";
}

std::string force_text(const Failure& failure) {
  const Remainder& left = failure.left;
  if (left.total.relative() <= failure.newton.tolerance) return {};
  const size_t worst = largest(left.force.size(), [&](size_t c) { return left.force[c].norm(); });
  return " The forces do not balance: their residual is " + number_text(left.total.relative()) +
         " of the nodal forces (tolerance " + number_text(failure.newton.tolerance) + "); worst at " +
         node_text(failure.problem, left.state, worst) + ", by " + number_text(left.force[worst].norm()) + " N.";
}

std::string gap_text(const Failure& failure) {
  const Remainder& left = failure.left;
  if (left.total.gap <= failure.newton.gap_tolerance) return {};
  const size_t worst = largest(left.opening.size(), [&](size_t c) { return left.opening[c]; });
  return " Contact is violated by " + number_text(left.total.gap) + " mm (tolerance " +
         number_text(failure.newton.gap_tolerance) + " mm); worst at " + node_text(failure.problem, left.state, worst) +
         ".";
}

std::string softest_text(const Failure& failure) {
  const SoftestMotion& softest = failure.left.softest;
  if (!softest.is_soft()) return {};
  std::string text = " Nothing resists there";
  if (softest.gives_way())
    text = " The garment gives way there by";
  else if (!softest.is_free())
    text = " Little resists there (" + number_text(softest.stiffness) + " of the mean stiffness)";
  return text + " a motion that is largest at " + node_text(failure.problem, failure.left.state, softest.cluster) +
         ", along " + direction_text(softest.direction) + ".";
}

}  // namespace

std::string what_failed(const Failure& failure) {
  std::string text = attempt_text(failure) + " " + end_text(failure) + ".";
  if (!failure.left.finite) return text + energy_text(failure);
  return text + force_text(failure) + gap_text(failure) + softest_text(failure);
}

std::string farthest_motion(const Failure& failure) {
  constexpr double noticeable = 1.0;  // mm
  if (!failure.left.finite) return {};
  const auto way = [&](size_t c) -> Vec3 { return failure.left.state.position[c] - failure.start.position[c]; };
  const size_t farthest = largest(failure.left.force.size(), [&](size_t c) { return way(c).norm(); });
  const double length = way(farthest).norm();
  if (length < noticeable) return {};
  return "it was still moving, farthest at " + node_text(failure.problem, failure.left.state, farthest) + ", by " +
         number_text(length) + " mm in the direction " + direction_text(way(farthest) / length) +
         " since the start of the stage: look whether anything holds it there";
}

std::string likely_cause(const Failure& failure) {
  for (const Cause cause : causes()) {
    std::string text = cause(failure);
    if (!text.empty()) return text;
  }
  return {};
}

}  // namespace toile::solve
