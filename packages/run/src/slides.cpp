#include "slides.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "toile/solve/connected_parts.hpp"

namespace toile::run {

namespace {

using solve::Vec3;

/// Of the nodes of some clusters.
struct Extent {
  Vec3 mean = Vec3::Zero();
  Eigen::AlignedBox3d box;
};

Extent extent(const solve::Problem& problem, const std::vector<int>& part, const std::vector<Vec3>& at) {
  Extent all;
  double count = 0.0;
  for (const int cluster : part)
    for (const int node : problem.clusters[static_cast<size_t>(cluster)]) {
      all.mean += at[static_cast<size_t>(node)];
      all.box.extend(at[static_cast<size_t>(node)]);
      count += 1.0;
    }
  all.mean /= count;
  return all;
}

bool is_moved(const solve::Support& support) {
  return support.displacement.norm() > 0.0 || support.turn.has_value();
}

}  // namespace

std::vector<std::string> parts_that_slid(const solve::Problem& problem, const std::vector<Vec3>& position) {
  constexpr double noticeable = 30.0, far = 0.25;  // mm; of the part's size
  std::vector<std::string> texts;
  const bool moved = std::any_of(problem.supports.begin(), problem.supports.end(), is_moved);
  if (problem.surface == nullptr || moved) return texts;
  for (const std::vector<int>& part : solve::connected_parts(problem)) {
    const Extent before = extent(problem, part, problem.mesh->placed), after = extent(problem, part, position);
    const Vec3 way = after.mean - before.mean;
    if (way.norm() < noticeable || way.norm() < far * after.box.diagonal().norm()) continue;
    const Vec3 direction = way.normalized();
    std::ostringstream text;
    text.precision(3);
    text << solve::panels_of(problem, part) << " went " << way.norm() << " mm as a whole, in the direction ("
         << direction[0] << ", " << direction[1] << ", " << direction[2]
         << "), from where it was placed: without friction a garment slides to where nothing stretches it. If it is "
            "to stay, hold an end of it (list \"Supports\")";
    texts.push_back(text.str());
  }
  return texts;
}

}  // namespace toile::run
