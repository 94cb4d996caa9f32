// What a scene can do without costs nothing in it: input/leave-out/strip.xml with one part of input/leave-out at a
// time.
#include <gmock/gmock.h>

#include <tuple>

#include "toile/base/variant.hpp"
#include "toile/run/session.hpp"

namespace toile::run {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr int across = 96, along = 32, nodes = (across + 1) * (along + 1);
/// Held in its plane, its two ends clamped: two displacements of every other node.
constexpr int plane_unknowns = 2 * (across - 1) * (along + 1);

struct Built {
  std::vector<std::string> used;
  int unknowns = 0, multipliers = 0;
  std::size_t pressures = 0, loads = 0, seams = 0;
  bool has_body = false;
};

Built run_with(const std::string& part = "") {
  const std::string folder = TOILE_SOURCE_DIR "/input/leave-out/";
  base::Texts files = {folder + "strip.xml"};
  if (!part.empty()) files.push_back(folder + part + ".xml");
  Session session(base::Variant(files, "scene").content(), folder + "strip.xml");
  session.run();
  const solve::SolveStatistics& work = session.record().statistics();
  const scene::Scene& scene = session.scene();
  return {scene.used(),
          work.unknowns,
          work.contact_nodes,
          scene.problem().pressures.size(),
          scene.problem().loads.size(),
          scene.garment().seams.size(),
          scene.surface() != nullptr};
}

// A scene that asks for nothing has the displacements that are free as its unknowns, and no other; no body, seam or
// load is built.
TEST(LeaveOut, NothingIsThereThatIsNotAskedFor) {
  const Built plain = run_with();
  EXPECT_THAT(plain.used, IsEmpty());
  EXPECT_EQ(plain.unknowns, plane_unknowns);
  EXPECT_EQ(plain.multipliers, 0);
  EXPECT_EQ(plain.pressures + plain.loads + plain.seams, 0U);
  EXPECT_FALSE(plain.has_body);
}

// Damping and wrinkling add no unknown, a body one multiplier for each node, bending two angles for each; a closed seam
// takes away those that its two edges share. None of them brings another part with it.
TEST(LeaveOut, APartAddsItsOwnUnknownsOnly) {
  for (const auto& [part, name, unknowns] :
       {std::tuple{"damping", "damping", plane_unknowns}, std::tuple{"wrinkling", "relaxed fabric", plane_unknowns},
        std::tuple{"contact", "body and contact", plane_unknowns + nodes}, std::tuple{"seams", "seams", plane_unknowns},
        std::tuple{"bending", "shells", plane_unknowns + 2 * nodes}}) {
    const Built with = run_with(part);
    EXPECT_THAT(with.used, ElementsAre(name));
    EXPECT_EQ(with.unknowns, unknowns) << part;
    EXPECT_EQ(with.multipliers, with.has_body ? nodes : 0) << part;
  }
}

}  // namespace
}  // namespace toile::run
