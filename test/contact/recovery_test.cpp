// The pressure that is recovered from tensions that are known, on a cylinder.
#include "toile/contact/recovery.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>

namespace toile::test {
namespace {

using contact::ContactCluster;
using contact::FabricElement;
using contact::FabricInContact;
using contact::TensionPoint;
using contact::Vec3;

constexpr double radius = 50.0;  // mm
constexpr int across = 9, along = 6;

Vec3 on_cylinder(double angle, double z) {
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

ContactCluster cluster_at(const Vec3& x, double force) {
  ContactCluster c;
  c.position = x;
  c.surface.normal = Vec3(x.x(), x.y(), 0.0).normalized();
  const Vec3 around(-c.surface.normal.y(), c.surface.normal.x(), 0.0);
  c.surface.hessian = around * around.transpose() / radius;
  c.surface.found = true;
  c.area = 1.0;
  c.force = force;
  return c;
}

/// A patch of a cylinder with unequal columns; hoop tension by height. Element (i, j) has its lower left node (i, j).
struct Patch : FabricInContact {
  explicit Patch(const std::function<double(double)>& tension) {
    for (int j = 0; j <= along; ++j)
      for (int i = 0; i <= across; ++i) {
        site_cluster.push_back(static_cast<int>(clusters.size()));
        clusters.push_back(
            cluster_at(on_cylinder(0.1 * i + 0.03 * std::sin(3.0 * i), 5.0 * j + std::sin(2.0 * i + j)), 1.0));
      }
    for (int j = 0; j < along; ++j)
      for (int i = 0; i < across; ++i) add({node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)}, tension);
  }
  static int node(int i, int j) { return j * (across + 1) + i; }
  ContactCluster& at(int site) { return clusters[static_cast<size_t>(site_cluster[static_cast<size_t>(site)])]; }

  void add(const std::array<int, 4>& sites, const std::function<double(double)>& tension) {
    FabricElement element{4, sites, static_cast<int>(points.size()), 4};
    for (const double u : {0.2, 0.8})
      for (const double v : {0.2, 0.8}) {
        TensionPoint p;
        const double shape[4] = {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
        for (size_t k = 0; k < 4; ++k) p.position += shape[k] * at(sites[k]).position;
        p.normal = Vec3(p.position.x(), p.position.y(), 0.0).normalized();
        const Vec3 around(-p.normal.y(), p.normal.x(), 0.0);
        p.area = 7.0;
        p.tension = p.laid = tension(p.position.z()) * around * around.transpose();
        p.body_normal = p.normal;
        points.push_back(p);
      }
    elements.push_back(element);
  }
};

double uniform(double) {
  return 0.3;
}

double linear(double z) {
  return 0.3 + 0.02 * z;
}

// A tension that is linear along the body is recovered exactly at every node, edges and corners too, and the estimate
// says so.
TEST(Recovery, IsExactForALinearTension) {
  Patch patch(linear);
  const contact::Recovery recovery = contact::recover(patch);
  for (size_t s = 0; s < recovery.site.size(); ++s) {
    const double exact = linear(patch.clusters[s].position.z()) / radius;
    EXPECT_NEAR(recovery.site[s].pressure, exact, 1e-10 * exact) << s;
    EXPECT_LE(recovery.site[s].error, 1e-9 * exact) << s;
  }
  EXPECT_EQ(recovery.isolated, 0);
  EXPECT_EQ(recovery.bridged, 0);
}

// A part of the tension that changes its sign within each element, as that of linear shape functions has, does not
// move the pressure, at edges and corners either.
TEST(Recovery, IsNotMovedByWhatChangesItsSignWithinAnElement) {
  Patch patch(uniform);
  for (const FabricElement& element : patch.elements)
    for (int q = 0; q < element.points; ++q)
      patch.points[static_cast<size_t>(element.first_point + q)].tension *= q % 2 == 0 ? 1.1 : 0.9;
  for (const contact::SitePressure& site : contact::recover(patch).site)
    EXPECT_NEAR(site.pressure, uniform(0.0) / radius, 1e-10 * uniform(0.0) / radius);
}

// Where a few elements are bad, no pressure is told to be much better than all are in the mean: their tensions are in
// balance with each other.
TEST(Recovery, TellsTheErrorOfTheRestEverywhere) {
  Patch patch(uniform);
  double largest = 0.0, least = 1e9;
  for (int i = 0; i < 4; ++i) patch.points[static_cast<size_t>(i)].laid *= 1.5;  // of the first element
  for (const contact::SitePressure& site : contact::recover(patch).site) {
    largest = std::max(largest, site.error);
    least = std::min(least, site.error);
  }
  EXPECT_GT(largest, 0.0);
  EXPECT_GE(least, 0.25 * largest);
}

// Free fabric that hovers by less than the body is known has the pressure as its error that it would make if the body
// reached it, T/R; one that hovers by more has none.
TEST(Recovery, TellsWhatAWiderBodyWouldBePressedBy) {
  for (const double gap : {0.1, 0.3}) {
    Patch patch(uniform);
    for (ContactCluster& cluster : patch.clusters) {
      cluster.force = 0.0;
      cluster.surface.gap = gap;
      cluster.doubt.gap = -0.2;
    }
    for (const contact::SitePressure& site : contact::recover(patch).site) {
      EXPECT_EQ(site.pressure, 0.0);
      EXPECT_EQ(site.error, 0.0);
      EXPECT_NEAR(site.of_body, gap < 0.2 ? uniform(0.0) / radius : 0.0, 1e-12);
    }
  }
}

// A load that pulls the fabric off the body takes its pressure from that of the tension.
TEST(Recovery, TakesThePressureOfLoads) {
  Patch patch(uniform);
  for (FabricElement& element : patch.elements) element.load = 0.001;  // along the points' normals, outwards
  const contact::Recovery recovery = contact::recover(patch);
  for (const contact::SitePressure& site : recovery.site)
    EXPECT_NEAR(site.pressure, uniform(0.0) / radius - 0.001, 1e-10 * uniform(0.0) / radius);
}

// Two pieces of fabric that a seam ties have their own pressure on either side of it.
TEST(Recovery, DoesNotFitAcrossASeamOfTwoFabrics) {
  Patch patch(uniform);
  const int first = static_cast<int>(patch.site_cluster.size());
  for (int j = 0; j <= along; ++j) {  // a second piece beyond the last column
    patch.site_cluster.push_back(Patch::node(across, j));
    for (int i = 1; i < 4; ++i) {
      patch.site_cluster.push_back(static_cast<int>(patch.clusters.size()));
      patch.clusters.push_back(cluster_at(on_cylinder(1.0 + 0.1 * i, 5.0 * j), 1.0));
    }
  }
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < 3; ++i) {
      const int s = first + 4 * j + i;
      patch.add({s, s + 1, s + 5, s + 4}, [](double z) { return 2.0 * uniform(z); });
    }
  const contact::Recovery recovery = contact::recover(patch);
  for (size_t s = 0; s < recovery.site.size(); ++s) {
    const double exact = (static_cast<int>(s) < first ? 1.0 : 2.0) * uniform(0.0) / radius;
    EXPECT_NEAR(recovery.site[s].pressure, exact, 1e-10 * exact) << s;
  }
}

// A free node has no pressure; those around it have their force over their area.
TEST(Recovery, UsesForcesAtTheBorderOfContact) {
  Patch patch(uniform);
  for (int j = 0; j <= along; ++j) {
    patch.at(Patch::node(0, j)).force = 0.0;
    patch.at(Patch::node(0, j)).surface.gap = 1.0;
  }
  for (int j = 0; j <= along; ++j) patch.at(Patch::node(1, j)).force = 0.004;
  const contact::Recovery recovery = contact::recover(patch);
  for (int j = 0; j <= along; ++j) {
    EXPECT_EQ(recovery.site[static_cast<size_t>(Patch::node(0, j))].pressure, 0.0);
    EXPECT_EQ(recovery.site[static_cast<size_t>(Patch::node(0, j))].error, 0.0);
    EXPECT_NEAR(recovery.site[static_cast<size_t>(Patch::node(1, j))].pressure, 0.004, 1e-15);
    EXPECT_GT(recovery.site[static_cast<size_t>(Patch::node(1, j))].error, 0.0);
    EXPECT_NEAR(recovery.site[static_cast<size_t>(Patch::node(2, j))].pressure, uniform(0.0) / radius, 1e-12);
  }
}

// A node in contact alone is counted, and its pressure is as uncertain as it is large.
TEST(Recovery, FlagsIsolatedContacts) {
  Patch patch(uniform);
  for (ContactCluster& c : patch.clusters) {
    c.force = 0.0;
    c.surface.gap = 1.0;
  }
  patch.at(Patch::node(4, 3)).force = 0.01;
  const contact::Recovery recovery = contact::recover(patch);
  EXPECT_EQ(recovery.isolated, 1);
  EXPECT_NEAR(recovery.site[static_cast<size_t>(Patch::node(4, 3))].pressure, 0.01, 1e-15);
  EXPECT_EQ(recovery.site[static_cast<size_t>(Patch::node(4, 3))].error, 0.01);
}

// Where the body turns between two nodes by more than its curvature at them tells, as over the tip of a cone, the error
// is the pressure; further off it is that of the fit.
TEST(Recovery, KnowsNothingOfAHiddenTurn) {
  Patch patch(linear);
  constexpr double edge = 0.5;  // rad
  const Eigen::AngleAxisd turn(edge, Vec3::UnitZ());
  for (int j = 0; j <= along; ++j)
    for (int i = 5; i <= across; ++i) {
      body::SurfacePoint& surface = patch.at(Patch::node(i, j)).surface;
      surface.normal = turn * surface.normal;
      surface.hessian = turn * surface.hessian * turn.inverse();
    }
  const contact::Recovery recovery = contact::recover(patch);
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i <= across; ++i) {
      const contact::SitePressure& site = recovery.site[static_cast<size_t>(Patch::node(i, j))];
      EXPECT_GT(site.pressure, 1e-3);
      if (i == 4 || i == 5) {
        EXPECT_GE(site.error, site.pressure);
      } else if (i < 4) {
        EXPECT_LT(site.error, 0.1 * site.pressure);
      }
    }
}

// A node that the tilt of its facets lifts by less than a chord sags, among nodes in contact, has its pressure; one
// that hovers over a hollow has none.
TEST(Recovery, BridgesANodeThatTiltLifts) {
  Patch patch(uniform);
  ContactCluster& lifted = patch.at(Patch::node(4, 3));
  lifted.force = 0.0;
  lifted.surface.gap = 0.01;
  contact::Recovery recovery = contact::recover(patch);
  EXPECT_EQ(recovery.bridged, 1);
  for (const contact::SitePressure& site : recovery.site)
    EXPECT_NEAR(site.pressure, uniform(0.0) / radius, 1e-10 * uniform(0.0) / radius);
  const body::Mat3 convex = lifted.surface.hessian;
  lifted.surface.hessian = -convex;  // a hollow
  recovery = contact::recover(patch);
  EXPECT_EQ(recovery.bridged, 0);
  EXPECT_EQ(recovery.site[static_cast<size_t>(Patch::node(4, 3))].pressure, 0.0);
  lifted.surface.hessian = convex;
  lifted.fixed = true;  // its support keeps it off the body
  recovery = contact::recover(patch);
  EXPECT_EQ(recovery.bridged, 0);
  lifted.fixed = false;
  lifted.surface.gap = 1.0;  // far more than 5 mm chords sag
  recovery = contact::recover(patch);
  EXPECT_EQ(recovery.bridged, 0);
  EXPECT_EQ(recovery.site[static_cast<size_t>(Patch::node(4, 3))].pressure, 0.0);
}

// What a support takes of the fabric's pull is no contact force; held at the body, a node has its pressure all the
// same, and held off it none.
TEST(Recovery, HeldNodesHaveThePressureOfTheirTension) {
  Patch patch(uniform);
  for (int i = 0; i <= across; ++i) {
    patch.at(Patch::node(i, 0)).force = i % 2 == 0 ? 0.0 : 7.0;
    patch.at(Patch::node(i, 0)).held = true;
  }
  contact::Recovery recovery = contact::recover(patch);
  for (const contact::SitePressure& site : recovery.site)
    EXPECT_NEAR(site.pressure, uniform(0.0) / radius, 1e-10 * uniform(0.0) / radius);
  for (int i = 0; i <= across; ++i) {
    patch.at(Patch::node(i, 0)).force = 0.0;
    patch.at(Patch::node(i, 0)).surface.gap = 0.5;
  }
  recovery = contact::recover(patch);
  for (int i = 0; i <= across; ++i) EXPECT_EQ(recovery.site[static_cast<size_t>(Patch::node(i, 0))].pressure, 0.0);
}

/// Mean over an element's points of the stretch along its chord when it is laid on the cylinder.
double laid_stretch(const FabricElement& element, double angle, const std::vector<double>& places) {
  std::array<const ContactCluster*, 4> nodes{};
  const ContactCluster a = cluster_at(on_cylinder(-angle, 0.0), 1.0), b = cluster_at(on_cylinder(angle, 0.0), 1.0);
  const ContactCluster c = cluster_at(on_cylinder(angle, 1.0), 1.0), d = cluster_at(on_cylinder(-angle, 1.0), 1.0);
  nodes = {&a, &b, &c, &d};
  const Vec3 chord = (b.position - a.position).normalized();
  double squares = 0.0;
  for (const double u : places) {
    const double shape[4] = {0.5 * (1 - u), 0.5 * u, 0.5 * u, 0.5 * (1 - u)};
    Vec3 x = Vec3::Zero();
    for (size_t i = 0; i < 4; ++i) x += shape[i] * nodes[i]->position;
    const contact::Laid laid = contact::laid_on(element, x, shape, nodes);
    EXPECT_NEAR(laid.normal.dot(Vec3::UnitX()), 1.0, 0.1 * angle * angle + std::abs(u - 0.5) * angle);
    squares += (laid.map * chord).squaredNorm() / static_cast<double>(places.size());
  }
  return std::sqrt(squares);
}

// Laid onto a cylinder, an element is as much longer as the arc is than the chord, at one point as at several.
TEST(Recovery, LaysChordsOnArcs) {
  constexpr double angle = 0.05;
  const double exact = angle / std::sin(angle);
  FabricElement one, four;
  one.nodes = four.nodes = 4;
  one.points = 1;
  four.points = 4;
  const double g = 0.5 / std::sqrt(3.0);
  EXPECT_NEAR(laid_stretch(four, angle, {0.5 - g, 0.5 + g}) - 1.0, exact - 1.0, 0.02 * (exact - 1.0));
  EXPECT_NEAR(laid_stretch(one, angle, {0.5}) - 1.0, exact - 1.0, 0.02 * (exact - 1.0));
}

}  // namespace
}  // namespace toile::test
