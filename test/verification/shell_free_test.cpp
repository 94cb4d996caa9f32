// Shells of Sze, Liu and Lo (2004) on free meshes: triangles, quadrilaterals, and both in one panel.
#include <gtest/gtest.h>
#include <Teuchos_XMLParameterListHelpers.hpp>

#include <cmath>

#include "reals.hpp"
#include "verification/print.hpp"
#include "verification/shell_scene.hpp"

namespace toile::test {
namespace {

using Teuchos::ParameterList;

/// A free mesh of a shell.
struct ShellMesh {
  std::string name;
  std::string elements;  ///< quadrilateral or triangle
  std::string integration;
  double size;         ///< mm
  double limit;        ///< accepted relative error
  bool mixed = false;  ///< every second quadrilateral cut in two
};

void PrintTo(const ShellMesh& mesh, std::ostream* out) {
  *out << mesh.name;
}

/// A scene of input/benchmarks with its panel meshed freely, in five steps.
ParameterList free_scene(const std::string& name, const ShellMesh& mesh) {
  ParameterList list = *Teuchos::getParametersFromXmlFile(TOILE_SOURCE_DIR "/input/benchmarks/" + name + ".xml");
  ParameterList& panel = list.sublist("Panels").sublist("shell");
  panel.remove("elements across");
  panel.remove("elements along");
  panel.set("mesher", "free");
  panel.set("element size", mesh.size);
  panel.set("elements", mesh.elements);
  panel.sublist("Shell").set("integration", mesh.integration);
  ParameterList& load = list.sublist("Stages").sublist("load");
  load.set("first step", 0.2);
  load.set("largest step", 0.2);
  return list;
}

PointHistory follow(const ParameterList& list, const ShellMesh& mesh) {
  PointHistory history = follow_points(base::validate(list, scene::scene_spec(), "shell.xml"), mesh.mixed);
  EXPECT_EQ(history.statistics.cut_backs, 0);
  return history;
}

class CantileverOnFreeMeshes : public testing::TestWithParam<ShellMesh> {};

// Cantilever 3.1, a tenth and a hundredth of its width thick (the force goes with the cube of it), two elements across:
// the tip's displacements are those of the inextensible elastica within 0.6 % (triangles) and 0.1 % (others).
TEST_P(CantileverOnFreeMeshes, IsAnElastica) {
  constexpr double u = 3.28941, w = 6.69964;
  for (const double thickness : {0.1, 0.01}) {
    ParameterList list = free_scene("cantilever-shear", GetParam());
    list.sublist("Materials").sublist("elastic").set("thickness", thickness);
    list.sublist("Loads").sublist("end").set("traction", reals({0.0, 0.0, 4e3 * std::pow(thickness, 3)}));
    const solve::Vec3 tip = follow(list, GetParam()).displacement.at("tip").back();
    print("cantilever, %-14s %4g mm, thickness %4g mm: error of u %5.2f %%, of w %5.2f %%\n", GetParam().name.c_str(),
          GetParam().size, thickness, 100.0 * (-tip.x() / u - 1.0), 100.0 * (tip.z() / w - 1.0));
    EXPECT_NEAR(-tip.x(), u, GetParam().limit * u) << thickness;
    EXPECT_NEAR(tip.z(), w, GetParam().limit * w) << thickness;
  }
}

INSTANTIATE_TEST_SUITE_P(Shells, CantileverOnFreeMeshes,
                         testing::Values(ShellMesh{"triangles", "triangle", "full", 0.55, 0.006},
                                         ShellMesh{"quadrilaterals", "quadrilateral", "reduced", 0.4, 0.001},
                                         ShellMesh{"mixed", "quadrilateral", "reduced", 0.4, 0.001, true}),
                         [](const auto& instance) { return instance.param.name; });

class HemisphereOnFreeMeshes : public testing::TestWithParam<ShellMesh> {};

// Hemisphere 3.4, doubly curved and bent without stretch, the hardest case for a triangle: both displacements are
// within 1 % of the published ones.
TEST_P(HemisphereOnFreeMeshes, HasThePublishedDisplacements) {
  const auto table = read_table("shell/3.4_hemisphere_hole.csv");
  const PointHistory history = follow(free_scene("hemisphere", GetParam()), GetParam());
  const double a = table.at("V_A").back(), b = table.at("minus_U_B").back();
  const double found_a = history.displacement.at("A").back().y(), found_b = -history.displacement.at("B").back().x();
  print("hemisphere, %-14s %4g mm: error of A %5.2f %%, of B %5.2f %%\n", GetParam().name.c_str(), GetParam().size,
        100.0 * (found_a / a - 1.0), 100.0 * (found_b / b - 1.0));
  EXPECT_NEAR(found_a, a, GetParam().limit * a);
  EXPECT_NEAR(found_b, b, GetParam().limit * b);
}

INSTANTIATE_TEST_SUITE_P(Shells, HemisphereOnFreeMeshes,
                         testing::Values(ShellMesh{"triangles", "triangle", "full", 0.43, 0.01},
                                         ShellMesh{"quadrilaterals", "quadrilateral", "reduced", 1.0, 0.01},
                                         ShellMesh{"mixed", "quadrilateral", "reduced", 0.43, 0.01, true}),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace toile::test
