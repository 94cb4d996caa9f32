#include <gmock/gmock.h>

#include <cstdlib>

#include "support.hpp"
#include "toile/result/exodus_writer.hpp"

namespace toile::result::test {
namespace {

const std::string python = "/usr/bin/python3";
const std::string script = std::string(TOILE_SOURCE_DIR) + "/doc/render.py";

double cylinder(double /*z*/) {
  return 30.0;
}
double sleeve(double /*z*/) {
  return 32.0;
}

/// A sleeve with a field on nodes and one on elements, on a body, or pressed flat into y = 0 without one.
std::string write_example(const TemporaryFolder& folder, bool flat = false) {
  mesh::Mesh garment = tube(sleeve, 20.0, 60.0, 24, 8);
  const body::TriangleMesh body = revolution(cylinder, 0.0, 100.0, 24, 10);
  if (flat)
    for (mesh::Vec3& node : garment.placed) node.y() = 0.0;
  FieldNames fields;
  fields.nodal = {{"pressure", "kPa"}};
  fields.element = {{"thickness", "mm"}};
  ExodusWriter writer(folder.file("out.exo"), garment, flat ? nullptr : &body, fields);
  StepData data;
  for (const mesh::Vec3& node : garment.placed) {
    data.displacement.push_back(mesh::Vec3(-node.x(), -node.y(), 0.0) / 32.0);
    data.nodal["pressure"].push_back(0.01 * node.z());
  }
  if (!flat) data.body_nodal["pressure"] = std::vector<double>(body.vertices.size(), 0.5);
  data.element["thickness"] = std::vector<double>(static_cast<std::size_t>(garment.elements()), 0.8);
  writer.write_step(1.0, data);
  return writer.path();
}

int run(const std::string& arguments, const std::string& messages) {
  return std::system((python + " " + script + " " + arguments + " 2> " + messages).c_str());
}

/// Width and height from the header of a PNG file.
std::pair<int, int> png_size(const std::string& path) {
  const std::string bytes = read_text(path);
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = at; i < at + 4 && i < bytes.size(); ++i) {
      value = 256 * value + static_cast<unsigned char>(bytes[i]);
    }
    return value;
  };
  return {number(16), number(20)};
}

class Render : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system((python + " -c 'import vtk' 2> /dev/null").c_str()) != 0) {
      GTEST_SKIP() << "python3-vtk9 is not installed";
    }
  }
};

// A standard viewer library opens the file as it is and draws nodal and element fields without a display.
TEST_F(Render, DrawsPictures) {
  const TemporaryFolder folder;
  const std::string input = write_example(folder);
  const std::string picture = folder.file("picture.png");
  for (const char* field : {"pressure", "thickness"}) {
    ASSERT_EQ(run(input + " " + picture + " --height 300 --field " + field, folder.file("messages")), 0)
        << read_text(folder.file("messages"));
    EXPECT_EQ(png_size(picture).second, 300) << field;
    EXPECT_GT(png_size(picture).first, 200) << field;
    std::filesystem::remove(picture);
  }
}

// A flat result is drawn from a side and refused, with a way out, from its edge.
TEST_F(Render, RefusesToLookAtAnEdge) {
  const TemporaryFolder folder;
  const std::string arguments = write_example(folder, true) + " " + folder.file("picture.png") + " --height 300";
  EXPECT_EQ(run(arguments, folder.file("messages")), 0) << read_text(folder.file("messages"));
  EXPECT_NE(run(arguments + " --up y", folder.file("messages")), 0);
  EXPECT_EQ(read_text(folder.file("messages")),
            "render.py: the result is flat and is seen from its edge; choose another --up or --angle\n");
}

// A field that is not in the file is refused with the list of those that are; the viewer sees vectors as one field.
TEST_F(Render, NamesTheFieldsThatAreThere) {
  const TemporaryFolder folder;
  const std::string input = write_example(folder);
  EXPECT_NE(run(input + " " + folder.file("picture.png") + " --field presure", folder.file("messages")), 0);
  EXPECT_EQ(
      read_text(folder.file("messages")),
      "render.py: no field 'presure' on the garment; there are: ObjectId, disp_, pattern_, pressure, thickness\n");
}

}  // namespace
}  // namespace toile::result::test
