#include "toile/result/exodus_writer.hpp"

#include <exodusII.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>

#include "support.hpp"
#include "toile/base/error.hpp"

namespace toile::result::test {
namespace {

using ::testing::ElementsAre;

const std::string long_name = "smallest principal Cauchy stress of the front panel, inner face";

/// Two panels (four quadrilaterals, one triangle), a body of two triangles.
struct Scene {
  mesh::Mesh garment;
  body::TriangleMesh body;
  FieldNames fields;

  Scene() {
    for (int i = 0; i < 9; ++i) {
      garment.pattern.emplace_back(10.0 * (i % 3), 20.0 * (i / 3));
      garment.placed.emplace_back(10.0 * (i % 3), 1.5, 20.0 * (i / 3));
    }
    for (int i = 0; i < 3; ++i) {
      garment.pattern.emplace_back(i, i * i);
      garment.placed.emplace_back(i, 2.5, i * i);
    }
    mesh::Block front;
    front.name = "front";
    front.connectivity = {0, 1, 4, 3, 1, 2, 5, 4, 3, 4, 7, 6, 4, 5, 8, 7};
    mesh::Block gusset;
    gusset.name = "gusset";
    gusset.nodes_per_element = 3;
    gusset.connectivity = {9, 10, 11};
    garment.blocks = {front, gusset};
    garment.edges = {{"front.left", {0, 3, 6}}, {"front.right", {2, 5, 8}}};
    body.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    body.triangles = {{0, 1, 2}, {0, 2, 3}};
    fields.nodal = {{"pressure", "kPa"}, {"gap", "mm"}};
    fields.element = {{"thickness", "mm"}, {long_name, "MPa"}};
    fields.body_element = {{"body_pressure", "kPa"}};
    fields.global = {{"load", ""}, {"strain_energy", "N mm"}};
  }

  static StepData step(double scale) {
    StepData data;
    std::vector<double> pressure;
    for (int i = 0; i < 12; ++i) {
      data.displacement.emplace_back(scale * i, scale * 2 * i, scale * 3 * i);
      pressure.push_back(scale + i);
    }
    data.nodal["pressure"] = pressure;
    data.nodal["gap"] = std::vector<double>(12, -scale);
    data.body_nodal["pressure"] = {scale, 2 * scale, 3 * scale, 4 * scale};
    data.element["thickness"] = {scale, 2 * scale, 3 * scale, 4 * scale, 5 * scale};
    data.element[long_name] = {1, 2, 3, 4, scale};
    data.body_element["body_pressure"] = {7 * scale, 8 * scale};
    data.global = {{"load", scale}, {"strain_energy", 100 * scale}};
    return data;
  }
};

/// Reads with the Exodus library alone.
class Reader {
 public:
  explicit Reader(const std::string& path) {
    ex_opts(EX_DEFAULT);
    int memory_word = sizeof(double);
    int file_word = 0;
    float version = 0;
    id_ = ex_open(path.c_str(), EX_READ, &memory_word, &file_word, &version);
    EXPECT_GE(id_, 0) << path;
    ex_set_max_name_length(id_, longest_name);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { ex_close(id_); }

  std::int64_t count(ex_inquiry what) const { return ex_inquire_int(id_, what); }

  std::string name(ex_entity_type type, int id) const {
    std::array<char, longest_name + 1> text{};
    EXPECT_EQ(ex_get_name(id_, type, id, text.data()), 0);
    return text.data();
  }

  std::vector<std::string> variables(ex_entity_type type) const {
    int count = 0;
    EXPECT_EQ(ex_get_variable_param(id_, type, &count), 0);
    std::vector<std::string> names;
    for (int i = 1; i <= count; ++i) {
      std::array<char, longest_name + 1> text{};
      EXPECT_EQ(ex_get_variable_name(id_, type, i, text.data()), 0);
      names.emplace_back(text.data());
    }
    return names;
  }

  std::vector<double> values(int step, ex_entity_type type, int index, int object, int size) const {
    std::vector<double> result(static_cast<std::size_t>(size), -999.0);
    EXPECT_EQ(ex_get_var(id_, step, type, index, object, size, result.data()), 0);
    return result;
  }

  int id() const { return id_; }

 private:
  int id_ = -1;
};

// Garment and body are one model: sizes, coordinates, blocks named as the panels, named edges as node sets.
TEST(ExodusWriter, WritesTheModel) {
  const TemporaryFolder folder;
  const Scene scene;
  const ExodusWriter writer(folder.file("out.exo"), scene.garment, &scene.body, scene.fields);
  const Reader file(writer.path());
  EXPECT_EQ(file.count(EX_INQ_DIM), 3);
  EXPECT_EQ(file.count(EX_INQ_NODES), 16);
  EXPECT_EQ(file.count(EX_INQ_ELEM), 7);
  EXPECT_EQ(file.count(EX_INQ_ELEM_BLK), 3);
  EXPECT_EQ(file.count(EX_INQ_NODE_SETS), 2);
  EXPECT_EQ(file.count(EX_INQ_TIME), 0);
  std::array<std::vector<double>, 3> x;
  x.fill(std::vector<double>(16));
  ASSERT_EQ(ex_get_coord(file.id(), x[0].data(), x[1].data(), x[2].data()), 0);
  EXPECT_EQ(x[0][8], 20.0);
  EXPECT_EQ(x[1][8], 1.5);
  EXPECT_EQ(x[2][8], 40.0);
  EXPECT_EQ(x[1][11], 2.5);
  EXPECT_EQ(x[1][15], 1.0);
  EXPECT_EQ(file.name(EX_ELEM_BLOCK, 1), "front");
  EXPECT_EQ(file.name(EX_ELEM_BLOCK, 2), "gusset");
  EXPECT_EQ(file.name(EX_ELEM_BLOCK, 3), "body");
  EXPECT_EQ(file.name(EX_NODE_SET, 2), "front.right");
  std::vector<int> nodes(3);
  ASSERT_EQ(ex_get_set(file.id(), EX_NODE_SET, 2, nodes.data(), nullptr), 0);
  EXPECT_THAT(nodes, ElementsAre(3, 6, 9));
  std::vector<int> triangles(6);
  ASSERT_EQ(ex_get_conn(file.id(), EX_ELEM_BLOCK, 3, triangles.data(), nullptr, nullptr), 0);
  EXPECT_THAT(triangles, ElementsAre(13, 14, 15, 13, 15, 16));
  EXPECT_THAT(file.variables(EX_NODAL),
              ElementsAre("disp_x", "disp_y", "disp_z", "pattern_x", "pattern_y", "pressure", "gap"));
  EXPECT_THAT(file.variables(EX_ELEM_BLOCK), ElementsAre("thickness", long_name, "body_pressure"));
  EXPECT_THAT(file.variables(EX_GLOBAL), ElementsAre("load", "strain_energy"));
}

// Each block carries the fields that belong to it and no others, so that viewers show no meaningless zeros.
TEST(ExodusWriter, TruthTableSeparatesGarmentAndBody) {
  const TemporaryFolder folder;
  const Scene scene;
  const ExodusWriter writer(folder.file("out.exo"), scene.garment, &scene.body, scene.fields);
  const Reader file(writer.path());
  std::vector<int> table(9);
  ASSERT_EQ(ex_get_truth_table(file.id(), EX_ELEM_BLOCK, 3, 3, table.data()), 0);
  EXPECT_THAT(table, ElementsAre(1, 1, 0, 1, 1, 0, 0, 0, 1));
}

// Two steps come back with their times and every value in its place.
TEST(ExodusWriter, WritesTwoSteps) {
  const TemporaryFolder folder;
  const Scene scene;
  ExodusWriter writer(folder.file("out.exo"), scene.garment, &scene.body, scene.fields);
  writer.write_step(0.5, Scene::step(0.5));
  writer.write_step(1.0, Scene::step(2.0));
  const Reader file(writer.path());
  ASSERT_EQ(file.count(EX_INQ_TIME), 2);
  std::vector<double> times(2);
  ASSERT_EQ(ex_get_all_times(file.id(), times.data()), 0);
  EXPECT_THAT(times, ElementsAre(0.5, 1.0));
  for (const auto& [step, scale] : {std::pair(1, 0.5), std::pair(2, 2.0)}) {
    EXPECT_EQ(file.values(step, EX_NODAL, 3, 1, 16)[5], 15 * scale);
    EXPECT_EQ(file.values(step, EX_NODAL, 3, 1, 16)[14], 0.0);
    EXPECT_EQ(file.values(step, EX_NODAL, 5, 1, 16)[8], 40.0);
    const std::vector<double> pressure = file.values(step, EX_NODAL, 6, 1, 16);
    EXPECT_EQ(pressure[11], scale + 11);
    EXPECT_EQ(pressure[15], 4 * scale);
    EXPECT_EQ(file.values(step, EX_NODAL, 7, 1, 16)[12], 0.0);
    EXPECT_THAT(file.values(step, EX_ELEM_BLOCK, 1, 1, 4), ElementsAre(scale, 2 * scale, 3 * scale, 4 * scale));
    EXPECT_THAT(file.values(step, EX_ELEM_BLOCK, 1, 2, 1), ElementsAre(5 * scale));
    EXPECT_THAT(file.values(step, EX_ELEM_BLOCK, 2, 2, 1), ElementsAre(scale));
    EXPECT_THAT(file.values(step, EX_ELEM_BLOCK, 3, 3, 2), ElementsAre(7 * scale, 8 * scale));
    EXPECT_THAT(file.values(step, EX_GLOBAL, 1, 0, 2), ElementsAre(scale, 100 * scale));
  }
}

// The file of a run that is still going on can be read after each step.
TEST(ExodusWriter, FileIsCompleteAfterEachStep) {
  const TemporaryFolder folder;
  const Scene scene;
  ExodusWriter writer(folder.file("out.exo"), scene.garment, &scene.body, scene.fields);
  for (int step = 1; step <= 3; ++step) {
    writer.write_step(step, Scene::step(step));
    const std::string copy = folder.file("copy" + std::to_string(step) + ".exo");
    std::filesystem::copy_file(writer.path(), copy);
    const Reader file(copy);
    EXPECT_EQ(file.count(EX_INQ_TIME), step);
    EXPECT_EQ(file.values(step, EX_GLOBAL, 1, 0, 2)[0], step);
  }
}

// A viewer that has the file open, with HDF5's lock on it, does not end the run.
TEST(ExodusWriter, WritesWhileAViewerLooks) {
  const TemporaryFolder folder;
  const Scene scene;
  ExodusWriter writer(folder.file("out.exo"), scene.garment, &scene.body, scene.fields);
  writer.write_step(0.5, Scene::step(0.5));
  const int viewer = ::open(writer.path().c_str(), O_RDONLY);
  ASSERT_EQ(::flock(viewer, LOCK_SH | LOCK_NB), 0);
  writer.write_step(1.0, Scene::step(1.0));
  ::close(viewer);
  EXPECT_EQ(Reader(writer.path()).count(EX_INQ_TIME), 2);
}

// A scene without a body has no body block and no zero fields for it.
TEST(ExodusWriter, WorksWithoutBody) {
  const TemporaryFolder folder;
  Scene scene;
  scene.fields.body_element.clear();
  ExodusWriter writer(folder.file("out.exo"), scene.garment, nullptr, scene.fields);
  StepData step = Scene::step(1.0);
  step.body_element.clear();
  step.body_nodal.clear();
  writer.write_step(1.0, step);
  const Reader file(writer.path());
  EXPECT_EQ(file.count(EX_INQ_NODES), 12);
  EXPECT_EQ(file.count(EX_INQ_ELEM_BLK), 2);
  EXPECT_EQ(file.values(1, EX_NODAL, 6, 1, 12)[11], 12.0);
}

// The unit of each field is in the file.
TEST(ExodusWriter, RecordsUnits) {
  const TemporaryFolder folder;
  const Scene scene;
  const ExodusWriter writer(folder.file("out.exo"), scene.garment, &scene.body, scene.fields);
  const Reader file(writer.path());
  std::vector<std::array<char, MAX_LINE_LENGTH + 1>> text(static_cast<std::size_t>(file.count(EX_INQ_INFO)));
  std::vector<char*> lines;
  for (auto& line : text) {
    lines.push_back(line.data());
  }
  ASSERT_EQ(ex_get_info(file.id(), lines.data()), 0);
  const std::vector<std::string> records(lines.begin(), lines.end());
  EXPECT_THAT(records, ::testing::Contains("nodal pressure [kPa]"));
  EXPECT_THAT(records, ::testing::Contains("element " + long_name + " [MPa]"));
}

// A folder that does not exist is reported with path and reason.
TEST(ExodusWriter, ReportsWhyTheFileCannotBeCreated) {
  const TemporaryFolder folder;
  const Scene scene;
  const std::string path = folder.file("missing/out.exo");
  EXPECT_EQ(input_error([&] { ExodusWriter(path, scene.garment, &scene.body, scene.fields); }),
            "cannot create the Exodus file '" + path + "': No such file or directory");
  EXPECT_EQ(input_error([&] { ExodusWriter(folder.file(""), scene.garment, &scene.body, scene.fields); }),
            "cannot create the Exodus file '" + folder.file("") + "': Is a directory");
}

// A file that disappears during the run is reported at the next step.
TEST(ExodusWriter, ReportsAFileThatWasRemoved) {
  const TemporaryFolder folder;
  const Scene scene;
  ExodusWriter writer(folder.file("out.exo"), scene.garment, &scene.body, scene.fields);
  std::filesystem::remove(writer.path());
  EXPECT_EQ(input_error([&] { writer.write_step(1.0, Scene::step(1.0)); }),
            "cannot open the Exodus file '" + writer.path() + "' for the next step: No such file or directory");
}

// Names that the file cannot hold or that cannot be told apart are refused before anything is written.
TEST(ExodusWriter, RefusesUnusableNames) {
  const TemporaryFolder folder;
  const std::string path = folder.file("out.exo");
  Scene scene;
  scene.garment.blocks[0].name = std::string(65, 'n');
  EXPECT_EQ(input_error([&] { ExodusWriter(path, scene.garment, &scene.body, scene.fields); }),
            "Exodus file '" + path + "': the name of panel '" + std::string(65, 'n') +
                "' has 65 characters, at most 64 are possible");
  scene.garment.blocks[0].name = "body";
  EXPECT_EQ(input_error([&] { ExodusWriter(path, scene.garment, &scene.body, scene.fields); }),
            "Exodus file '" + path + "': two panels have the name 'body'");
  EXPECT_FALSE(std::filesystem::exists(path));
}

// A field that is forgotten, misspelt or of the wrong size is a fault of the program and leaves the file as it was.
TEST(ExodusWriter, RefusesIncompleteSteps) {
  const TemporaryFolder folder;
  const Scene scene;
  ExodusWriter writer(folder.file("out.exo"), scene.garment, &scene.body, scene.fields);
  const auto message = [&](const StepData& data) {
    try {
      writer.write_step(1.0, data);
    } catch (const base::Error& error) {
      EXPECT_EQ(error.code(), base::ExitCode::internal_error);
      return std::string(error.what());
    }
    return std::string();
  };
  StepData data = Scene::step(1.0);
  data.element.erase("thickness");
  EXPECT_EQ(message(data), "field 'thickness' of an Exodus step is missing");
  data.element["thickness"] = {1.0};
  EXPECT_EQ(message(data), "field 'thickness' of an Exodus step has 1 values instead of 5");
  data = Scene::step(1.0);
  data.nodal["presure"] = std::vector<double>(12);
  EXPECT_EQ(message(data), "field 'presure' of an Exodus step was not declared");
  data = Scene::step(1.0);
  data.global.erase("load");
  EXPECT_EQ(message(data), "field 'load' of an Exodus step is missing");
  EXPECT_EQ(writer.steps(), 0);
  EXPECT_EQ(Reader(writer.path()).count(EX_INQ_TIME), 0);
}

// A run that goes on leaves the file, byte for byte, that it leaves in one go, although the last step was written and
// not counted; a file of another garment, or with too few steps, is refused.
TEST(ExodusWriter, GoesOnAfterAStep) {
  const TemporaryFolder folder;
  const Scene scene;
  const std::string whole = folder.file("whole.exo"), parts = folder.file("parts.exo");
  ExodusWriter once(whole, scene.garment, &scene.body, scene.fields);
  for (const int step : {1, 2, 3}) once.write_step(step, Scene::step(step));
  {
    ExodusWriter first(parts, scene.garment, &scene.body, scene.fields);
    for (const int step : {1, 2}) first.write_step(step, Scene::step(10 + step));
  }
  {
    ExodusWriter first(parts, scene.garment, &scene.body, scene.fields);
    for (const int step : {1, 2}) first.write_step(step, Scene::step(step == 1 ? 1 : 12));
  }
  ExodusWriter rest(parts, scene.garment, &scene.body, scene.fields);
  rest.go_on(1);
  for (const int step : {2, 3}) rest.write_step(step, Scene::step(step));
  EXPECT_EQ(read_text(parts), read_text(whole));
  ExodusWriter more(parts, scene.garment, &scene.body, scene.fields);
  EXPECT_THAT(input_error([&] { more.go_on(4); }), ::testing::HasSubstr("it holds 3 steps, and 4 were accepted"));
  Scene other;
  other.garment.placed[0].x() += 1.0;
  ExodusWriter of_other(parts, other.garment, &other.body, other.fields);
  EXPECT_THAT(input_error([&] { of_other.go_on(1); }), ::testing::HasSubstr("it is of another garment or body"));
}

}  // namespace
}  // namespace toile::result::test
