#include "toile/result/body_map.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "support.hpp"

namespace toile::result::test {
namespace {

constexpr double radius = 60.0;
constexpr double offset = 0.5;

double cylinder(double /*z*/) {
  return radius;
}
double sleeve_radius(double /*z*/) {
  return radius + offset;
}

/// A sleeve from height 50 to 150 on a cylinder from 0 to 200, with a pressure that is linear in height.
struct Sleeve {
  mesh::Mesh mesh = tube(sleeve_radius, 50.0, 100.0, 72, 20);
  body::TriangleMesh body = revolution(cylinder, 0.0, 200.0, 60, 41);
  std::vector<double> pressure;
  std::vector<double> distance = std::vector<double>(mesh.placed.size(), offset);

  Sleeve() {
    for (const mesh::Vec3& node : mesh.placed) {
      pressure.push_back(pressure_at(node.z()));
    }
  }
  static double pressure_at(double z) { return 1.0 + 0.01 * z; }
  std::vector<double> map() const {
    GarmentOnBody garment{&mesh, mesh.placed, tied_by_place(mesh), distance, {}};
    for (const mesh::Vec3& node : mesh.placed) {
      garment.normal.push_back(mesh::Vec3(node.x(), node.y(), 0.0).normalized());
    }
    return BodyMap(garment, body).on(pressure);
  }
  int covered(const std::vector<double>& field) const {
    return static_cast<int>(std::count_if(field.begin(), field.end(), [](double p) { return p > 0.0; }));
  }
};

/// The field is the sleeve's under the sleeve, and zero further than `margin` (mm) from it.
void expect_under_sleeve(const body::TriangleMesh& body, const std::vector<double>& field, double margin) {
  for (std::size_t i = 0; i < field.size(); ++i) {
    const double z = body.vertices[i].z();
    if (z > 50.0 && z < 150.0) {
      EXPECT_NEAR(field[i], Sleeve::pressure_at(z), 1e-9) << "height " << z;
    } else if (z < 50.0 - margin || z > 150.0 + margin) {
      EXPECT_EQ(field[i], 0.0) << "height " << z;
    }
  }
}

// Under the sleeve the body shows the garment's pressure exactly, beyond its edges none.
TEST(BodyMap, CylinderCarriesTheSleevesPressure) {
  const Sleeve sleeve;
  const std::vector<double> field = sleeve.map();
  expect_under_sleeve(sleeve.body, field, 0.25);
  EXPECT_GT(sleeve.covered(field), 1000);
}

// Which side of a panel faces the body does not matter.
TEST(BodyMap, PanelMayBeTurnedInsideOut) {
  Sleeve sleeve;
  std::vector<int>& connectivity = sleeve.mesh.blocks[0].connectivity;
  for (std::size_t i = 0; i < connectivity.size(); i += 4) {
    std::swap(connectivity[i + 1], connectivity[i + 3]);
  }
  expect_under_sleeve(sleeve.body, sleeve.map(), 0.25);
}

// The skin of a neighbouring limb, within reach but facing the other way, takes no pressure.
TEST(BodyMap, NeighbouringLimbTakesNone) {
  Sleeve sleeve;
  const body::TriangleMesh other = revolution(cylinder, 0.0, 200.0, 60, 41);
  const int own = static_cast<int>(sleeve.body.vertices.size());
  for (const body::Vec3& vertex : other.vertices) {
    sleeve.body.vertices.push_back(vertex + body::Vec3(2.0 * radius + 2.0, 0.0, 0.0));
  }
  for (const auto& [a, b, c] : other.triangles) {
    sleeve.body.triangles.push_back({a + own, b + own, c + own});
  }
  const std::vector<double> field = sleeve.map();
  for (std::size_t i = static_cast<std::size_t>(own); i < field.size(); ++i) {
    EXPECT_EQ(field[i], 0.0) << "vertex " << i;
  }
  EXPECT_GT(sleeve.covered(field), 1000);
}

// A garment that stands off further than the limit is mapped where its distance says so, and not otherwise.
TEST(BodyMap, LimitGrowsWithTheDistance) {
  Sleeve sleeve;
  for (mesh::Vec3& node : sleeve.mesh.placed) {
    node.head<2>() *= (radius + 8.0) / (radius + offset);
  }
  EXPECT_EQ(sleeve.covered(sleeve.map()), 0);
  std::fill(sleeve.distance.begin(), sleeve.distance.end(), 8.0);
  expect_under_sleeve(sleeve.body, sleeve.map(), 4.0);
}

/// Makes the sleeve of two layers, the outer one with half of the inner one's pressure, turned inside out and rotated
/// by `turn` of an element.
void add_layer(Sleeve& sleeve, double turn) {
  const std::size_t nodes = sleeve.mesh.placed.size();
  mesh::Block outer = sleeve.mesh.blocks[0];
  outer.name = "outer";
  for (int& node : outer.connectivity) {
    node += static_cast<int>(nodes);
  }
  for (std::size_t i = 0; i < outer.connectivity.size(); i += 4) {
    std::swap(outer.connectivity[i + 1], outer.connectivity[i + 3]);
  }
  sleeve.mesh.blocks.push_back(outer);
  const Eigen::AngleAxisd rotation(turn * 2.0 * M_PI / 72, mesh::Vec3::UnitZ());
  for (std::size_t n = 0; n < nodes; ++n) {
    sleeve.mesh.placed.push_back(rotation * sleeve.mesh.placed[n]);
    sleeve.mesh.pattern.push_back(sleeve.mesh.pattern[n]);
    sleeve.pressure.push_back(0.5 * sleeve.pressure[n]);
    sleeve.distance.push_back(offset);
  }
}

// The skin feels the sum of the layers that lie over it, whichever of their sides they show it, even where they lie in
// the same place node on node.
TEST(BodyMap, LayersAddUp) {
  for (const double turn : {0.0, 0.3}) {
    Sleeve sleeve;
    add_layer(sleeve, turn);
    const std::vector<double> field = sleeve.map();
    for (std::size_t i = 0; i < field.size(); ++i) {
      const double z = sleeve.body.vertices[i].z();
      if (z > 50.0 && z < 150.0) {
        EXPECT_NEAR(field[i], 1.5 * Sleeve::pressure_at(z), 1e-9) << "height " << z << ", turn " << turn;
      }
    }
  }
}

// Fabric that spans a groove lies over its walls, but not on them: they have no pressure of the shoulders.
TEST(BodyMap, WallsOfASpannedGrooveTakeNone) {
  constexpr double half = 6.0, wide = 40.0;  // mm
  const double slope = M_PI * 70.0 / 180.0;  // of the walls
  const auto wall = [&](double x) { return mesh::Vec3(-std::copysign(std::sin(slope), x), 0.0, std::cos(slope)); };
  mesh::Mesh mesh;
  GarmentOnBody garment{&mesh, {}, {}, {}, {}};
  std::vector<double> pressure;
  constexpr int along = 4, across = 40;
  for (int i = 0; i <= across; ++i)
    for (int j = 0; j <= along; ++j) {
      const double x = 2.0 * wide * i / across - wide, inside = half - std::abs(x);
      garment.position.emplace_back(x, 2.0 * j, 0.0);
      mesh.pattern.emplace_back(x, 2.0 * j);
      garment.distance.push_back(inside > 0.0 ? inside * std::sin(slope) : 0.0);
      garment.normal.push_back(inside > 0.0 ? wall(x) : mesh::Vec3::UnitZ());
      pressure.push_back(inside > 0.0 ? 0.0 : 1.0);
    }
  mesh.placed = garment.position;
  mesh.blocks.emplace_back();
  mesh.blocks[0].nodes_per_element = 4;
  for (int i = 0; i < across; ++i)
    for (int j = 0; j < along; ++j) {
      const int a = i * (along + 1) + j, b = a + along + 1;
      mesh.blocks[0].connectivity.insert(mesh.blocks[0].connectivity.end(), {a, b, b + 1, a + 1});
    }
  std::vector<mesh::Vec3> points, normals;
  for (const double depth : {2.5, 3.0, 4.0, 4.5}) {
    points.emplace_back(depth / std::tan(slope) - half, 3.3, -depth);
    normals.push_back(wall(-1.0));
  }
  points.emplace_back(-half - 3.0, 3.3, 0.0);
  normals.push_back(mesh::Vec3::UnitZ());
  const BodyMap map(garment, points, normals);
  const std::vector<double> on = map.on(pressure), distance = map.over(garment.distance);
  const std::vector<double> over = map.over(pressure);
  EXPECT_GT(over[0], 0.1);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(map.layers()[i], 1) << i;
    EXPECT_EQ(on[i], 0.0) << i;
    EXPECT_NEAR(distance[i] + map.excess()[i], -points[i].z(), 1e-9) << i;
  }
  EXPECT_NEAR(on[4], 1.0, 1e-9);
}

// Facets that cut through an edge of the body lie on it, however deep they pass below.
TEST(BodyMap, FacetsThroughAnEdgeLieOnIt) {
  Sleeve sleeve;
  std::fill(sleeve.distance.begin(), sleeve.distance.end(), 0.0);
  for (mesh::Vec3& node : sleeve.mesh.placed) node.head<2>() *= (radius - 3.0) / (radius + offset);
  expect_under_sleeve(sleeve.body, sleeve.map(), 3.1);
}

}  // namespace
}  // namespace toile::result::test
