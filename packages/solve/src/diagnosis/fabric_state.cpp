#include "diagnosis/fabric_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "diagnosis/place.hpp"
#include "fields/block_arrays.hpp"

namespace toile::solve {

namespace {

/// How far a point is from its natural state: stretching and compressing by the same factor counts the same.
double strain_of(const FabricPoint& point) {
  const double least = std::max(point.stretch[1], std::numeric_limits<double>::min());
  return std::max(std::abs(std::log(point.stretch[0])), std::abs(std::log(least)));
}

FabricPoint point_at(const Problem& problem, size_t b, size_t element, const std::vector<Vec3>& position,
                     const double* C) {
  const mesh::Block& block = problem.mesh->blocks[b];
  FabricPoint point;
  point.found = true;
  point.panel = block.name;
  point.element = static_cast<int>(element) + 1;
  const size_t nodes = static_cast<size_t>(block.nodes_per_element);
  for (size_t i = 0; i < nodes; ++i) {
    const int n = block.connectivity[element * nodes + i];
    point.position += position[n] / static_cast<double>(nodes);
    point.pattern += problem.mesh->pattern[n] / static_cast<double>(nodes);
  }
  const double mean = 0.5 * (C[0] + C[1]), radius = std::hypot(0.5 * (C[0] - C[1]), C[2]);
  point.stretch = {std::sqrt(mean + radius), std::sqrt(std::max(0.0, mean - radius))};
  point.along = {std::sqrt(C[0]), std::sqrt(C[1])};
  return point;
}

}  // namespace

FabricState fabric_state(const Problem& problem, const State& state) {
  FabricState out;
  const std::vector<Vec3> position = node_positions(problem, state);
  for (size_t b = 0; b < problem.mesh->blocks.size(); ++b) {
    const BlockArrays arrays(problem, b, state, position);
    const element::Element& element = *problem.models[b].element;
    const element::PointFields fields = element.fields(arrays.batch());
    const size_t points = static_cast<size_t>(element.points());
    for (size_t k = 0; k < fields.status.size(); ++k) {
      const double* C = &fields.C[3 * k];
      ++out.points;
      if (!std::isfinite(C[0] + C[1] + C[2])) continue;
      const FabricPoint point = point_at(problem, b, k / points, position, C);
      if (!out.most_stretched.found || point.stretch[0] > out.most_stretched.stretch[0]) out.most_stretched = point;
      if (!out.most_compressed.found || point.stretch[1] < out.most_compressed.stretch[1]) out.most_compressed = point;
      if (fields.status[k] != material::point_not_admissible) {
        for (size_t i = 0; i < 2; ++i) {
          const double stress = fields.cauchy_principal[2 * k + i];
          (stress > 0.0 ? out.tension : out.compression) += std::abs(stress);
        }
        continue;
      }
      ++out.without_energy;
      if (!out.worst_without_energy.found || strain_of(point) > strain_of(out.worst_without_energy))
        out.worst_without_energy = point;
    }
  }
  return out;
}

bool FabricState::is_slack() const {
  constexpr double none = 1e-6;
  return most_stretched.found && most_stretched.stretch[0] < 1.0 + none && most_compressed.stretch[1] > 1.0 - none;
}

std::string FabricPoint::text() const {
  std::ostringstream out;
  out.precision(3);
  out << "panel \"" << panel << "\", element " << element << ", " << place_text(position, pattern) << ": stretch "
      << along[0] << " along the wale and " << along[1] << " along the course, principal stretches " << stretch[0]
      << " and " << stretch[1];
  return out.str();
}

}  // namespace toile::solve
