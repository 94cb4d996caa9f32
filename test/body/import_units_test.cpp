// Units, axes and sizes of body files.
#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "body/import_support.hpp"
#include "body/meshes.hpp"
#include "toile/body/analytic.hpp"

namespace toile::body {
namespace {

using test::ball;
using test::message;
using test::volume;
using testing::AllOf;
using testing::HasSubstr;

/// The ball stretched to these extents.
TriangleMesh figure(const Vec3& extents) {
  TriangleMesh mesh = ball();
  Eigen::AlignedBox3d box;
  for (const Vec3& v : mesh.vertices) box.extend(v);
  for (Vec3& v : mesh.vertices) v = v.cwiseProduct(extents.cwiseQuotient(box.sizes()));
  return mesh;
}

// A body whose height cannot be one is refused with all three extents and every unit that makes an allowed height of
// it, never with one alone; the right scale mends it.
TEST(Import, WrongUnitListsAllThatFit) {
  const TriangleMesh mesh = figure({600.0, 600.0, 1700.0});
  const std::string metres = test::write_obj("metres", mesh, 1e-3);
  EXPECT_THAT(message(metres, {}), AllOf(HasSubstr(metres + ": the body is 1.7 mm high (z); allowed is 300 to 3000 mm. "
                                                            "Its extents in x, y, z are 0.6 x 0.6 x 1.7 mm. "),
                                         HasSubstr("feet with z up (182.9 x 182.9 x 518.2 mm): \"scale\" = 304.8; "
                                                   "m with z up (600 x 600 x 1700 mm): \"scale\" = 1000: "),
                                         HasSubstr("\"height range\"")));
  ImportOptions options;
  options.scale = 1000.0;
  EXPECT_NEAR(volume(import_body(metres, options).mesh) / volume(mesh), 1.0, 1e-12);
  EXPECT_THAT(message(test::write_obj("inches", mesh, 1.0 / 25.4), {}),
              AllOf(HasSubstr("cm with z up (236.2 x 236.2 x 669.3 mm): \"scale\" = 10; "),
                    HasSubstr("inches with z up (600 x 600 x 1700 mm): \"scale\" = 25.4")));
  options.scale = 1e4;
  EXPECT_THAT(message(metres, options),
              AllOf(HasSubstr("6000 x 6000 x 1.7e+04 mm after \"scale\" and \"up\""), HasSubstr("\"scale\" = 1000:")));
  EXPECT_THAT(message(test::write_obj("huge", mesh, 1e6), {}), HasSubstr("No usual unit makes a body of it. "));
}

// A body with y up is not taken for a low one; with "up" it is turned, not mirrored, and its height is along z.
TEST(Import, YUp) {
  const TriangleMesh lying = figure({400.0, 1700.0, 320.0});
  const std::string file = test::write_obj("y-up", lying);
  EXPECT_THAT(message(file, {}), AllOf(HasSubstr("it seems to lie, for y is the longest"),
                                       HasSubstr("mm with y up (400 x 320 x 1700 mm): \"scale\" = 1, \"up\" = \"y\"")));
  ImportOptions options;
  options.up_is_known = true;
  EXPECT_EQ(message(file, options), "") << "a low body that its user knows of";
  options.up = Axis::y;
  const Import turned = import_body(file, options);
  EXPECT_NEAR(turned.extents.z(), 1700.0, 1e-9);
  EXPECT_NEAR(turned.extents.y(), 320.0, 1e-9);
  EXPECT_NEAR(volume(turned.mesh) / volume(lying), 1.0, 1e-12);
  options.up = Axis::x;
  options.greatest_height = 3000.0;
  const Import other = import_body(file, options);
  EXPECT_NEAR(other.extents.z(), 400.0, 1e-9);
  EXPECT_NEAR(volume(other.mesh) / volume(lying), 1.0, 1e-12);
}

// A body of 200 mm, as for a sleeve on a forearm, is accepted when the range of heights says so, and only then.
TEST(Import, SmallBodyNeedsItsRange) {
  const std::string file = test::write_obj("forearm", ellipsoid(40.0, 100.0)->triangles(10.0));
  EXPECT_THAT(message(file, {}), HasSubstr("\"height range\" what is allowed"));
  ImportOptions options;
  options.least_height = 150.0;
  EXPECT_EQ(message(file, options), "");
}

}  // namespace
}  // namespace toile::body
