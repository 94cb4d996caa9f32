#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

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

/// Runs Python in which `render` is the script, `vtk` the viewer and `check` what must hold.
int run_python(const std::string& code, const TemporaryFolder& folder) {
  const std::string file = folder.file("check.py");
  std::ofstream(file) << "import sys, types\nsys.path.insert(0, '" TOILE_SOURCE_DIR "/doc')\nimport render, vtk\n"
                      << "def check(holds, what):\n  if not holds: sys.exit('does not hold: ' + str(what))\n"
                      << code;
  return std::system(("PYTHONDONTWRITEBYTECODE=1 " + python + " " + file + " 2> " + folder.file("messages")).c_str());
}

// No two labels of a colour bar are the same, however narrow its range is; a wide range has three digits.
TEST_F(Render, LabelsDiffer) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_python("for low, high in ((0, 0.97), (0.9998, 1.0002), (1e-9, 1.5e-9), (-3, 5), (21.3, 21.300001), "
                       "(0, 8.57), (-1e-12, 1e-12), (1e6, 1e6 + 1)):\n"
                       "  form = render.label_format((low, high), 6)\n"
                       "  labels = [form % (low + i * (high - low) / 5) for i in range(6)]\n"
                       "  check(len(set(labels)) == 6, labels)\n"
                       "check(render.label_format((0, 8.57), 6) == '%.3g', 'three digits')\n",
                       folder),
            0)
      << read_text(folder.file("messages"));
}

// The colour bar stands beside what is shown, of garments high and wide: their parts of the picture do not overlap, and
// all of garment and body lies in its own.
TEST_F(Render, TheColourBarCoversNothing) {
  const TemporaryFolder folder;
  const std::string input = write_example(folder);
  EXPECT_EQ(run_python("blocks = render.read(vtk, '" + input + "', -1)\n" + R"(
for stretch in (0.02, 1.0, 40.0):
  for grid in blocks.values():
    for i in range(grid.GetNumberOfPoints()):
      x, y, z = grid.GetPoint(i)
      grid.GetPoints().SetPoint(i, stretch * x, stretch * y, z)
  options = types.SimpleNamespace(field='pressure', largest=None, up='z', angle=30.0, elevation=0.0, height=300, no_seams=False)
  (shown, bar), ratio = render.build_scene(vtk, blocks, options, 'pressure')
  check(shown.GetViewport()[2] <= bar.GetViewport()[0], 'parts beside each other')
  window = vtk.vtkRenderWindow()
  window.SetOffScreenRendering(1)
  window.SetSize(round(ratio * 300), 300)
  window.AddRenderer(shown)
  left, bottom, right, top = shown.GetViewport()
  box = shown.ComputeVisiblePropBounds()
  for corner in range(8):
    shown.SetWorldPoint(box[corner & 1], box[2 + (corner >> 1 & 1)], box[4 + (corner >> 2)], 1.0)
    shown.WorldToDisplay()
    x, y, depth = shown.GetDisplayPoint()
    check(-1 <= x <= right * round(ratio * 300) + 1 and -1 <= y <= 301, (stretch, x, y))
)",
                       folder),
            0)
      << read_text(folder.file("messages"));
}

// The colours of a field start from zero unless that would hide its differences, and those of a constant one too: what
// is touched has another colour on the body than what is not.
TEST_F(Render, ColoursTellTouchedFromUntouched) {
  const TemporaryFolder folder;
  const std::string input = write_example(folder);
  EXPECT_EQ(run_python("blocks = render.read(vtk, '" + input + "', -1)\n" + R"(
grid = blocks['tube']
def limits(low, high):
  values = grid.GetPointData().GetArray('pressure')
  for i in range(values.GetNumberOfTuples()): values.SetValue(i, low if i % 2 else high)
  values.Modified()
  return render.value_range([grid], 'pressure')
check(limits(0.1, 0.8) == (0.0, 0.8), 'from zero')
check(limits(0.7, 0.8) == (0.7, 0.8), 'narrow')
check(limits(0.8, 0.8 + 1e-13)[0] == 0.0, 'constant')
check(limits(-0.8, -0.8) == (-0.8, 0.0), 'constant, negative')
check(limits(0.0, 0.0) == (0.0, 1.0), 'zero')
for low in (0.0, 0.7):
  colours = render.colour_map(vtk, (low, 0.8), grey_below=True)
  rgb = [0.0] * 3
  colours.GetColor(0.0, rgb)
  check(max(abs(a - b) for a, b in zip(rgb, render.GREY)) < 0.01, rgb)
  colours.GetColor(max(low, 0.02), rgb)
  check(max(abs(a - b) for a, b in zip(rgb, render.GREY)) > 0.1, rgb)
)",
                       folder),
            0)
      << read_text(folder.file("messages"));
}

// Seams are where edges lie on each other: the eight edges along the tube, and none around its open ends.
TEST_F(Render, FindsSeams) {
  const TemporaryFolder folder;
  const std::string input = write_example(folder);
  EXPECT_EQ(run_python("blocks = render.read(vtk, '" + input + "', -1)\n" + R"(
lines = render.seams(vtk, [blocks['tube']])
check(lines.GetNumberOfLines() == 8, lines.GetNumberOfLines())
lengths = [lines.GetCell(i).GetBounds() for i in range(8)]
check(all(abs(b[5] - b[4] - 7.5) < 1e-9 and b[1] - b[0] < 1e-9 for b in lengths), lengths)
)",
                       folder),
            0)
      << read_text(folder.file("messages"));
}

// Pressures are shown in mmHg on request, from the kPa of the file; nothing else is.
TEST_F(Render, ShowsMmHg) {
  const TemporaryFolder folder;
  const std::string input = write_example(folder);
  EXPECT_EQ(run_python("blocks = render.read(vtk, '" + input + "', -1)\n" + R"(
before = render.value_range([blocks['tube']], 'pressure')
render.to_mmhg(blocks, 'pressure')
after = render.value_range([blocks['tube']], 'pressure')
check(abs(after[1] - 7.50062 * before[1]) < 1e-12, (before, after))
check(abs(before[1] - 0.8) < 1e-12, before)
)",
                       folder),
            0)
      << read_text(folder.file("messages"));
  const std::string picture = " " + folder.file("picture.png") + " --height 300 --mmhg";
  EXPECT_EQ(run(input + picture, folder.file("messages")), 0) << read_text(folder.file("messages"));
  EXPECT_NE(run(input + picture + " --field thickness", folder.file("messages")), 0);
  EXPECT_EQ(read_text(folder.file("messages")), "render.py: --mmhg is for pressures, but the field is 'thickness'\n");
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
