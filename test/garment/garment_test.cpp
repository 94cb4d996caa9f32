#include "toile/garment/garment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lists.hpp"
#include "surfaces.hpp"
#include "toile/mesh/partition.hpp"

namespace toile::garment {
namespace {

using test::add_rectangle;
using test::add_seam;
using test::reals;

/// Front and back of a sleeve, sewn along both sides and wrapped with their natural width.
Garment sleeve(const body::Surface& body) {
  Teuchos::ParameterList panels, seams;
  for (const char* name : {"front", "back"}) {
    Teuchos::ParameterList& panel = add_rectangle(panels, name, 150.0, 200.0, 10, 16);
    panel.set("material", std::string(name) + " knit");
    Teuchos::ParameterList& placement = panel.sublist("Placement");
    placement.set("type", std::string("wrap"));
    placement.set("axis bottom", reals({0.0, 0.0, 0.0}));
    placement.set("axis top", reals({0.0, 0.0, 1.0}));
    placement.set("from", 0.0);
    placement.set("to", 200.0);
    placement.set("angle", name == std::string("front") ? 0.0 : 180.0);
  }
  add_seam(seams, "one side", "front.right", "back.left");
  add_seam(seams, "other side", "back.right", "front.left");
  const base::List seam_list = base::validate(seams, seams_spec(), "scene.xml");
  return build_garment(base::validate(panels, panels_spec(), "scene.xml"), &seam_list, &body);
}

// A sewn garment keeps the order, names and materials of its panels, and its seams start open where the fabric is
// narrow.
TEST(Garment, SleeveIsComplete) {
  const Garment garment = sleeve(test::EllipticCylinder(60.0, 60.0));
  EXPECT_EQ(garment.mesh.blocks[0].material, "front knit");
  EXPECT_EQ(garment.mesh.blocks[1].name, "back");
  EXPECT_EQ(garment.mesh.blocks[1].material, "back knit");
  EXPECT_EQ(garment.clusters.members.size(), 2u * 11u * 17u - 2u * 17u);
  const double open = 0.5 * (2.0 * M_PI * 60.0 - 300.0);  // of each seam, along the arc
  for (const Seam& seam : garment.seams) {
    for (const auto& [a, b] : seam.pairs) {
      const double chord = (garment.mesh.placed[a] - garment.mesh.placed[b]).norm();
      EXPECT_NEAR(chord, 2.0 * 60.0 * std::sin(0.5 * open / 60.0), 1e-3);
    }
  }
}

// Each panel is a shell or a membrane of its own.
TEST(Garment, ShellsByPanel) {
  Teuchos::ParameterList panels;
  add_rectangle(panels, "band", 150.0, 20.0, 6, 2).sublist("Shell").set("layers", 7);
  add_rectangle(panels, "strip", 150.0, 50.0, 6, 2);
  const Garment garment = build_garment(base::validate(panels, panels_spec(), "scene.xml"), nullptr, nullptr);
  ASSERT_EQ(garment.shells.size(), 2u);
  ASSERT_TRUE(garment.shells[0]);
  EXPECT_EQ(garment.shells[0]->layers, 7);
  EXPECT_FALSE(garment.shells[1]);
}

// Without seams every node is a cluster of its own.
TEST(Garment, WithoutSeamsNodesAreAlone) {
  Teuchos::ParameterList panels;
  add_rectangle(panels, "strip", 150.0, 50.0, 6, 2);
  const Garment garment = build_garment(base::validate(panels, panels_spec(), "scene.xml"), nullptr, nullptr);
  EXPECT_TRUE(garment.seams.empty());
  EXPECT_EQ(garment.clusters.members.size(), 21u);
  EXPECT_EQ(garment.clusters.of_node[7], 7);
}

// Partners of a seam have one owner, and that owner works on an element of theirs.
TEST(Garment, SeamPartnersHaveOneOwner) {
  const Garment garment = sleeve(test::EllipticCylinder(60.0, 60.0));
  const mesh::Partition split = mesh::partition(garment.mesh, garment.clusters.of_node, 3);
  ASSERT_EQ(split.cluster_rank.size(), garment.clusters.members.size());
  for (const Seam& seam : garment.seams) {
    for (const auto& [a, b] : seam.pairs) {
      const int owner = split.cluster_rank[garment.clusters.of_node[a]];
      EXPECT_EQ(owner, split.cluster_rank[garment.clusters.of_node[b]]);
      int element = 0, touching = 0;
      for (const mesh::Block& block : garment.mesh.blocks) {
        for (int e = 0; e < block.size(); ++e, ++element) {
          for (int k = 0; k < 4; ++k) {
            const int node = block.connectivity[4 * e + k];
            if ((node == a || node == b) && split.element_rank[element] == owner) ++touching;
          }
        }
      }
      EXPECT_GT(touching, 0);
    }
  }
}

}  // namespace
}  // namespace toile::garment
