#pragma once

#include <Teuchos_ParameterList.hpp>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "toile/run/session.hpp"

namespace toile::test {

/// Its contact, and what its pressure counts on.
struct SleeveContact {
  double relative_stiffness = 10.0;     ///< augmentation
  bool inner_face = false;              ///< half the thickness inside the mid-surface, not at it
  bool pressure_on_inner_face = false;  ///< per area of the inner face
};

/// A rectangle 2 pi r0 x l0 (course around, wale along z), sewn to itself round a body from the start.
struct SleeveOptions {
  Teuchos::ParameterList body;           ///< the scene's list "Body"
  std::string material = "neo-hookean";  ///< type of the fabric; see `set`
  double r0 = 50.0, l0 = 100.0;          ///< mm
  double from = 0.0, to = 100.0;         ///< heights between which it is placed, mm
  int around = 24, along = 8;            ///< quadrilaterals
  std::string hold_bottom = "z";         ///< directions that are held; empty: free
  std::string hold_top = "z";
  double angle = 0.0;                       ///< of the panel's centre line, degrees
  double offset = 0.0;                      ///< of the start from the body, mm
  std::array<double, 2> axis = {0.0, 0.0};  ///< x, y of the vertical axis of the placement, mm
  SleeveContact contact;
  /// Integration of a shell: full, reduced; empty: a membrane. Seam and ends of a shell keep their directors, which a
  /// tube without seam and ends would do, so that they make no edge layer of bending.
  std::string shell;
  std::string set = "pantyhose";  ///< of the fabric's parameters
};

/// The sleeve after one stage "settle".
struct Sleeve {
  int around = 0, along = 0;
  std::unique_ptr<run::Session> session;
  const scene::Scene* scene = nullptr;
  solve::Fields fields;
  solve::StepReport report;
  std::vector<std::string> notes;

  int node(int i, int j) const { return j * (around + 1) + i; }
  const solve::Vec3& position(int i, int j) const { return fields.position[node(i, j)]; }
  double pressure(int i, int j) const { return fields.pressure[node(i, j)]; }
  /// Positions of the nodes of row j once round.
  std::vector<solve::Vec3> ring(int j) const;
  /// Written contact forces, those of the supports and the pins: their sum over the sum of their magnitudes.
  double imbalance() const;
  /// Largest |gap| of a node with contact force, mm.
  double largest_gap() const;
};

/// The list that a scene file of this sleeve would hold.
Teuchos::ParameterList sleeve_list(const SleeveOptions& options);

/// Builds the scene and settles it, on all ranks of MPI's world.
Sleeve settle(const SleeveOptions& options);

/// List "Body" with a type; numbers are added with set().
Teuchos::ParameterList body_list(const std::string& type);

/// Fails the test unless the written contact forces are in balance with the supports (1e-6 of the magnitudes) and no
/// node in contact has a gap above 1e-6 mm.
void expect_balanced(const Sleeve& sleeve);

}  // namespace toile::test
