// The seams at the start: gaps, order of their edges, whether they can close beside the body.
#pragma once

#include <string>
#include <vector>

#include "toile/scene/scene.hpp"

namespace toile::scene {

/// How the edges of one seam lie to each other where their panels are placed.
struct SeamStart {
  double mean_gap = 0.0, largest_gap = 0.0;  ///< mm, between the nodes that are sewn together
  double other_gap = 0.0;                    ///< mm, mean if the second edge were sewn from its other end
  /// Do the edges run alike: from -1 (against each other) over 0 (across) to 1; as sewn, and from the other end.
  double likeness = 0.0, other_likeness = 0.0;
  bool crosses_corner = false;  ///< the edges share a corner, which is sewn to something else
  double depth = 0.0;           ///< mm, largest depth in the body of the middle between two nodes that are sewn
  bool through_body = false;    ///< most of the lines between nodes that are sewn go through the body
  std::string nearest_edge;     ///< that could take the place of the second one and is much nearer; empty: none
  double nearest_gap = 0.0;     ///< mm, mean gap to it
};

/// [seam] in the order of Garment::seams.
std::vector<SeamStart> look_at_seams(const Scene& scene);

/// Two edges with as many nodes that face each other and belong to no seam.
struct FacingEdges {
  std::string first, second;
  double gap = 0.0;  ///< mm, mean
};
/// Left and right sides only; none without a body.
std::vector<FacingEdges> unsewn_facing_edges(const Scene& scene);

/// Index of a seam that makes a Moebius band of panels, together with the seams before it; -1: none.
int moebius_seam(const Scene& scene);

}  // namespace toile::scene
