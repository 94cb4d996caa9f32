#include "toile/result/results_file.hpp"

#include <gmock/gmock.h>

#include "support.hpp"
#include "toile/result/exodus_writer.hpp"

namespace toile::result::test {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;

/// One quadrilateral, a body of one triangle.
mesh::Mesh quadrilateral() {
  mesh::Mesh garment;
  garment.pattern = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  garment.placed = {{0, 0, 5}, {1, 0, 5}, {1, 1, 5}, {0, 1, 5}};
  mesh::Block front;
  front.name = "front";
  front.connectivity = {0, 1, 2, 3};
  garment.blocks = {front};
  return garment;
}

/// Two steps of it.
void write(const std::string& path, bool with_body) {
  body::TriangleMesh body;
  body.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  body.triangles = {{0, 1, 2}};
  FieldNames fields;
  fields.nodal = {{"pressure", "kPa"}};
  fields.element = {{"thickness", "mm"}};
  fields.global = {{"residual", ""}, {"strain_energy", "N mm"}};
  ExodusWriter writer(path, quadrilateral(), with_body ? &body : nullptr, fields);
  for (int step = 1; step <= 2; ++step) {
    StepData data;
    data.displacement.assign(4, mesh::Vec3(0, 0, 10.0 * step));
    data.nodal["pressure"] = {1.0 * step, 2.0 * step, 3.0 * step, 4.0 * step};
    if (with_body) data.body_nodal["pressure"] = {5, 6, 7};
    data.element["thickness"] = {0.5 * step};
    data.global = {{"residual", 0.1 / step}, {"strain_energy", 7.0 * step}};
    writer.write_step(step, data);
  }
}

const FieldValues& field(const std::vector<FieldValues>& all, const std::string& name) {
  for (const FieldValues& one : all)
    if (one.name.name == name) return one;
  throw std::runtime_error("no field " + name);
}

// What was written is read: places, elements and fields of the last step with their units, global fields of all steps.
TEST(ResultsFile, HoldsTheLastStepAndTheHistory) {
  const TemporaryFolder folder;
  write(folder.file("results.exo"), true);
  const Results results = read_results(folder.file("results.exo"));
  EXPECT_EQ(results.steps, 2);
  EXPECT_EQ(results.garment_nodes, 4);
  EXPECT_THAT(results.position[0], ElementsAre(0, 1, 1, 0, 0, 1, 0));
  EXPECT_THAT(results.position[2], ElementsAre(25, 25, 25, 25, 0, 0, 0));
  ASSERT_EQ(results.garment.size(), 1U);
  EXPECT_EQ(results.garment[0].name, "front");
  EXPECT_THAT(results.garment[0].connectivity, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(field(results.garment[0].fields, "thickness").values, ElementsAre(1.0));
  ASSERT_EQ(results.body.size(), 1U);
  EXPECT_THAT(results.body[0].connectivity, ElementsAre(4, 5, 6));
  EXPECT_TRUE(results.body[0].fields.empty());
  EXPECT_THAT(field(results.nodal, "pressure").values, ElementsAre(2, 4, 6, 8, 5, 6, 7));
  EXPECT_EQ(field(results.nodal, "pressure").name.unit, "kPa");
  EXPECT_THAT(field(results.global, "residual").values, ElementsAre(0.1, 0.05));
  EXPECT_THAT(field(results.global, "strain_energy").values, ElementsAre(7, 14));
  EXPECT_EQ(field(results.global, "strain_energy").name.unit, "N mm");
}

// Without a body every node is the garment's.
TEST(ResultsFile, HasNoBodyIfThereWasNone) {
  const TemporaryFolder folder;
  write(folder.file("results.exo"), false);
  const Results results = read_results(folder.file("results.exo"));
  EXPECT_TRUE(results.body.empty());
  EXPECT_EQ(results.garment_nodes, 4);
}

// A file whose last byte is missing is refused, with both sizes.
TEST(ResultsFile, RefusesACutFile) {
  const TemporaryFolder folder;
  const std::string path = folder.file("results.exo");
  write(path, true);
  const auto size = std::filesystem::file_size(path);
  std::filesystem::resize_file(path, size - 1);
  EXPECT_THAT(input_error([&] { read_results(path); }),
              EndsWith("results.exo: it was cut off: it has " + std::to_string(size - 1) + " bytes of " +
                       std::to_string(size)));
}

}  // namespace
}  // namespace toile::result::test
