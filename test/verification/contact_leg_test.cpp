#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "toile/body/import.hpp"
#include "toile/body/level_set.hpp"
#include "verification/print.hpp"
#include "verification/ring.hpp"
#include "verification/sleeve_scene.hpp"

namespace toile::test {
namespace {

struct Noise {
  double largest = 0.0, squares = 0.0;
  int count = 0;
  void add(const std::vector<double>& values) {
    for (const double v : values) {
      largest = std::max(largest, std::abs(v));
      squares += v * v;
      ++count;
    }
  }
  double rms() const { return std::sqrt(squares / count); }
};

/// Mean of the vertices of the left leg between two heights.
solve::Vec3 leg_centre(const body::TriangleMesh& mesh, double bottom, double top) {
  solve::Vec3 lower = solve::Vec3::Constant(1e9), upper = -lower;
  for (const solve::Vec3& v : mesh.vertices) {
    if (v.x() < 0.0 || v.x() > 200.0 || v.z() < bottom || v.z() > top) continue;
    lower = lower.cwiseMin(v);
    upper = upper.cwiseMax(v);
  }
  return 0.5 * (lower + upper);
}

// On the thigh of a real body the pressure varies by less than 10 % of its local mean at the wavelengths of facets,
// below the mean edge length there, with nothing chosen by hand; the written field is in balance.
TEST(Thigh, PressureNoiseOfFacets) {
  const std::string file = TOILE_SOURCE_DIR "/input/bodies/female_body.obj";
  const body::TriangleMesh whole = body::import_body(file, {}).mesh;
  const solve::Vec3 centre = leg_centre(whole, 600.0, 680.0);

  SleeveOptions o;
  o.body = body_list("file").set("file", file);
  o.material = "rebar";
  o.r0 = 43.0;
  o.l0 = 70.0;
  o.from = 600.0;
  o.to = 680.0;
  o.axis = {centre.x(), centre.y()};
  o.around = 160;
  o.along = 24;
  const Sleeve sleeve = settle(o);
  expect_balanced(sleeve);

  constexpr double edge = 27.0;  // mm, mean between the heights of the sleeve
  const auto facets = body::facet_surface(whole, "facets");
  Noise smooth, faceted;
  for (int j = 3; j <= o.along - 3; ++j) {
    const std::vector<solve::Vec3> ring = sleeve.ring(j);
    std::vector<double> pressure;
    for (int i = 0; i < o.around; ++i) pressure.push_back(sleeve.pressure(i, j));
    EXPECT_GT(*std::min_element(pressure.begin(), pressure.end()), 0.0);
    smooth.add(short_waves(ring, pressure, edge));
    faceted.add(short_waves(ring, turning(*facets, ring), edge));
  }
  print(
      "thigh: noise below 27 mm: %.2f %%, largest %.2f %%; the same nodes on the facets: %.0f %%, %.0f %%; balance "
      "%.1e, gap %.1e mm\n",
      100.0 * smooth.rms(), 100.0 * smooth.largest, 100.0 * faceted.rms(), 100.0 * faceted.largest, sleeve.imbalance(),
      sleeve.largest_gap());
  EXPECT_LE(smooth.largest, 0.1);
  EXPECT_GT(faceted.rms(), 0.1) << "this measure does not see the facets";
}

// The written field is in balance on a leg by formula too, with contact at the inner face of the fabric.
TEST(Leg, WrittenFieldIsInBalance) {
  SleeveOptions o;
  o.body = body_list("leg");
  o.material = "itskov";
  o.r0 = 28.0;
  o.l0 = 250.0;
  o.from = 150.0;
  o.to = 440.0;
  o.offset = 0.3;
  o.around = 32;
  o.along = 48;
  o.contact.inner_face = true;
  const Sleeve sleeve = settle(o);
  expect_balanced(sleeve);
  print("leg: balance %.1e, gap %.1e mm\n", sleeve.imbalance(), sleeve.largest_gap());
}

}  // namespace
}  // namespace toile::test
