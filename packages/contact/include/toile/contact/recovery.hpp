#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <vector>

#include "toile/body/surface.hpp"
#include "toile/contact/law.hpp"

namespace toile::contact {

/// One integration point of the fabric, in space.
struct TensionPoint {
  Vec3 position = Vec3::Zero();     ///< mm
  Vec3 normal = Vec3::Zero();       ///< of the element, either way, unit
  double area = 0.0;                ///< current, mm^2
  Mat3 tension = Mat3::Zero();      ///< force per current length, N/mm
  Mat3 laid = Mat3::Zero();         ///< the same of the element laid onto the body, see laid_on()
  Vec3 body_normal = Vec3::Zero();  ///< of the body below the point; zero where the element is not in full contact
  std::array<Vec3, 4> force = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(),
                               Vec3::Zero()};  ///< what `tension` does to the element's nodes, N
};

/// One element of the fabric: up to four sites, in their order around it, and its points [first_point, first_point +
/// points).
struct FabricElement {
  int nodes = 0;
  std::array<int, 4> site = {};
  int first_point = 0;
  int points = 0;
  double load = 0.0;  ///< pressure of a load on it, along the normals of its points, MPa
};

/// What is tied together: one position, one place on the body, one contact force.
struct ContactCluster {
  Vec3 position = Vec3::Zero();  ///< mm
  body::SurfacePoint surface;    ///< of the body, seen from there
  body::SurfaceDoubt doubt;      ///< of the surface there
  double offset = 0.0;           ///< contact surface inside the mid-surface, mm
  double area = 0.0;             ///< current mid-surface area that belongs to it, mm^2
  double force = 0.0;            ///< of contact, N
  /// A support takes a part of what the fabric presses, which is no contact force: being at the body is contact then.
  bool held = false;
  bool fixed = false;  ///< held in all directions: where it hovers, its support keeps it off the body

  /// In contact.
  bool touches() const {
    constexpr double tolerance = 1e-6;  // mm
    return force > 0.0 || (held && surface.found && std::abs(surface.gap - offset) <= tolerance);
  }
};

/// A site is a place where one piece of fabric has a pressure of its own: a node, or the nodes that a seam ties within
/// a piece. A seam between two pieces has a site on either side, so that no fit crosses it.
struct FabricInContact {
  std::vector<TensionPoint> points;
  std::vector<FabricElement> elements;
  std::vector<int> site_cluster;  ///< [site] its cluster
  std::vector<ContactCluster> clusters;
  double stiffness = 0.0;  ///< of the fabric, force per length over strain, N/mm: what a wider body does to the tension
};

/// Pressure of a site, per current mid-surface area.
struct SitePressure {
  double pressure = 0.0;  ///< MPa, never negative
  double error = 0.0;     ///< estimate of its error by the mesh, MPa
  /// Estimate of its error by the shape of the body, MPa; of fabric that hovers by less than the body is known, what it
  /// presses if the body reaches it.
  double of_body = 0.0;
  /// What the doubt of the body changes the pressure by, MPa, with its sign: its mean over a line is the error of the
  /// mean, and the turns of a closed line are 2 pi however it is curved.
  double body_change = 0.0;
};

struct Recovery {
  std::vector<SitePressure> site;
  int isolated = 0;  ///< clusters in contact whose neighbours are all free: nodal forces without a place on the mesh
  int bridged = 0;   ///< free clusters between neighbours in contact, as near as a chord: taken as in contact
};

/// Pressure (MPa) of a contact force (N) on the area that belongs to it (mm^2); 0 where none does. Exact for a constant
/// pressure.
double pressure(double force, double area);

/// The pressure that the fabric's tension makes on the body, recovered at every site: tension x curvature, with the
/// tension of a quadratic least-squares fit over the elements around the site, and the curvature of the body's smooth
/// surface, less the pressure of loads. Of second order, on free triangles nearly; a nodal force over an area converges
/// on few meshes. See
/// doc/theory.md, "Pressure".
///
/// Sites at the border of contact, which are loaded on a part of their area, have their force, freed of what the tilt
/// of the facets makes. Free sites have no pressure.
Recovery recover(const FabricInContact& fabric);

/// The map of tangent vectors of an element, at one of its points, onto the tangent plane of the body's level surface
/// on which its nodes lie, and the normal of that surface.
struct Laid {
  Mat3 map = Mat3::Identity();
  Vec3 normal = Vec3::Zero();
};

/// `shape`: shape functions of the nodes at `point`. The surface between the nodes is told by what is known at them;
/// normal and gap are accurate to third and fourth order of the element's size. Of an element of one point they are
/// means over the element.
Laid laid_on(const FabricElement& element, const Vec3& point, const double* shape,
             const std::array<const ContactCluster*, 4>& clusters);

}  // namespace toile::contact
