#include "drape_fault.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "start_text.hpp"

namespace toile::scene {
namespace {

using mesh::Vec2;
using mesh::Vec3;

constexpr double closed = 1.0;          // mm
constexpr double most_stretched = 3.0;  // length over pattern length

constexpr const char* look = ". \"toile check SCENE --output FOLDER\" writes how the panels lie, to be looked at";

/// Largest principal stretch of an element: of the linear map between two of its lines in the pattern and in space.
double major_stretch(const mesh::Mesh& mesh, const int* nodes, int count) {
  const int a = nodes[0], b = nodes[count == 4 ? 2 : 1], c = nodes[count == 4 ? 1 : 0], d = nodes[count == 4 ? 3 : 2];
  Eigen::Matrix2d flat;
  Eigen::Matrix<double, 3, 2> placed;
  flat << mesh.pattern[b] - mesh.pattern[a], mesh.pattern[d] - mesh.pattern[c];
  placed << mesh.placed[b] - mesh.placed[a], mesh.placed[d] - mesh.placed[c];
  const Eigen::Matrix<double, 3, 2> map = placed * flat.inverse();
  return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(map.transpose() * map).eigenvalues()[1]);
}

/// That half of a panel's elements exceed.
double median_stretch(const mesh::Mesh& mesh, const mesh::MeshedPanel& panel) {
  std::vector<double> all;
  for (const mesh::Block& block : mesh.blocks) {
    if (&mesh.panel_of(block) != &panel) continue;
    const std::size_t per = static_cast<std::size_t>(block.nodes_per_element);
    for (std::size_t e = 0; e < block.connectivity.size(); e += per)
      all.push_back(major_stretch(mesh, &block.connectivity[e], block.nodes_per_element));
  }
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  return *middle;
}

std::string too_small(const mesh::Mesh& mesh, const drape::Outcome& outcome, double stretch) {
  const std::string needed = short_number(stretch);
  return "the pattern is too small for the body: to lie round it, half of panel \"" +
         mesh.panel_of_node(outcome.most_stretched).name + "\" would need a stretch of " + needed +
         " and more, at most " + short_number(outcome.largest_stretch) + " times near " +
         place_text(mesh.placed[outcome.most_stretched]) + ", and knits stand " + short_number(most_stretched) +
         ". A pattern " + needed +
         " times as wide would lie on it. Check the unit and the size of the pattern and of the body, and from where "
         "the panel comes" +
         look;
}

std::string caught(const mesh::Mesh& mesh, const drape::Outcome& outcome, double stretch) {
  return "panel \"" + mesh.panel_of_node(outcome.most_stretched).name +
         "\" is caught: a side of an element is stretched " + short_number(outcome.largest_stretch) + " times near " +
         place_text(mesh.placed[outcome.most_stretched]) + ", and knits stand " + short_number(most_stretched) +
         ", though half of the panel is stretched by less than " + short_number(stretch) +
         ". It may hang on a limb that is in its way, or a sleeve is too narrow for its arm: start it where it will "
         "lie "
         "(\"Placement\")" +
         look;
}

std::string still_open(const garment::Garment& garment, const garment::Clusters& clusters,
                       const drape::Outcome& outcome) {
  const auto widest = static_cast<std::size_t>(outcome.widest);
  return "after " + std::to_string(outcome.rounds) + " rounds the seam \"" +
         garment::seam_names(clusters, garment.seams)[widest] + "\" is still open by " +
         short_number(outcome.largest_opening) + " mm near " +
         place_text(garment.mesh.placed[clusters.members[widest].front()]) +
         ": a panel may hang on a limb that is in its way, or supports hold the two sides of the seam where they are "
         "placed, at different heights" +
         look;
}

/// Mean distance of the fabric from the body; 0 if it touches anywhere.
double mean_gap(const mesh::Mesh& mesh, const body::Surface& body, double touching) {
  double sum = 0.0;
  for (const Vec3& at : mesh.placed) {
    const double gap = body.closest(at).gap;
    if (gap < touching) return 0.0;
    sum += gap;
  }
  return sum / static_cast<double>(mesh.nodes());
}

std::string too_large(double gap, double distance) {
  return "the garment touches the body nowhere: once draped it is " + short_number(gap) +
         " mm away on average, as if it were " + short_number(2.0 * M_PI * (gap - distance)) +
         " mm wider round than the body. It would press nowhere, and there are no \"Loads\" that it would carry. Check "
         "the unit and the size of the pattern and of the "
         "body, and whether the panels start round the part of the body that is meant" +
         look;
}

}  // namespace

std::string drape_fault(const base::List& scene, const garment::Garment& garment, const garment::Clusters& clusters,
                        const body::Surface& body, const drape::Outcome& outcome) {
  const base::List list = scene.list("Drape");
  const auto of_list = [&list](const std::string& problem) {
    return list.file() + ": " + list.path() + ": " + problem;
  };
  const bool overstretched = outcome.largest_stretch > most_stretched;
  constexpr double small = 1.5;  // of a panel whose size is the cause, and not its place
  const double stretch =
      overstretched ? median_stretch(garment.mesh, garment.mesh.panel_of_node(outcome.most_stretched)) : 1.0;
  if (stretch > small) return of_list(too_small(garment.mesh, outcome, stretch));
  if (outcome.largest_opening > closed) return message_of(list, "most rounds", still_open(garment, clusters, outcome));
  if (overstretched) return of_list(caught(garment.mesh, outcome, stretch));
  const double distance = list.real("distance");
  constexpr double near = 1.0;  // mm
  const double gap = scene.has_list("Loads") ? 0.0 : mean_gap(garment.mesh, body, distance + near);
  return gap > 0.0 ? of_list(too_large(gap, distance)) : std::string();
}

}  // namespace toile::scene
