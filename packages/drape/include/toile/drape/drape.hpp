#pragma once

#include <string>
#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/body/surface.hpp"
#include "toile/mesh/mesh.hpp"

namespace toile::drape {

/// How a garment is laid onto its body before anything is solved.
struct Options {
  int most_rounds = 2000;       ///< of the constraints
  double distance = 1.0;        ///< of the fabric from the body that is kept, mm
  double largest_move = 4;      ///< of a node in a round, mm: less than half of the thinnest limb
  double stretch_wale = 1.0;    ///< of the fabric where it lies, along its wales
  double stretch_course = 1.0;  ///< and along its courses
};

/// A direction in which a node stays where it is placed.
struct Held {
  int node = 0;
  mesh::Vec3 direction;  ///< of unit length
};

/// Description of the list "Drape", and how it is read.
base::Spec drape_spec();
Options read_options(const base::List& list);

/// What was reached.
struct Outcome {
  int rounds = 0;
  double largest_opening = 0.0;  ///< of a seam before it was tied, mm
  int widest = -1;               ///< the cluster with it; -1: no seam
  double largest_stretch = 1.0;  ///< length over pattern length of an element's side
  int most_stretched = -1;       ///< a node of that side
  double last_move = 0.0;        ///< of a node in the last round, mm
};

/// Draws the sewn nodes together and lays the panels round the body: rounds of position-based constraints (Mueller et
/// al. 2007) on the mesh as it is, in which sides of elements do not stretch, sewn nodes come together and no node gets
/// into the body. Little resists compression, nothing has inertia: the result is a start for a solve, not an
/// equilibrium. `clusters`: nodes that seams tie. `held`: by supports. Changes `mesh.placed` (nodes of a cluster end at
/// one place) and `mesh.normal`.
Outcome drape(mesh::Mesh& mesh, const std::vector<std::vector<int>>& clusters, const std::vector<Held>& held,
              const body::Surface& body, const Options& options);

}  // namespace toile::drape
