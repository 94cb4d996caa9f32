#include "example.hpp"

#include <fstream>

#include "toile/report/report.hpp"
#include "toile/result/exodus_writer.hpp"

namespace toile::report::test {

using namespace result;

Example::Example(const std::vector<std::string>& names) {
  const mesh::Mesh garment = result::test::tube([](double) { return 30.0; }, 20.0, 60.0, 24, 8);
  const body::TriangleMesh body = result::test::revolution([](double) { return 30.0; }, 0.0, 100.0, 24, 10);
  garment_nodes = garment.nodes();
  body_nodes = static_cast<int>(body.vertices.size());
  FieldNames fields;
  for (const std::string& name : names) fields.nodal.push_back({name, "kPa"});
  fields.element = {{"stretch_wale", ""}};
  fields.global = {{"residual", ""}, {"strain_energy", "N mm"}};
  ExodusWriter writer(results(), garment, &body, fields);
  for (int step = 1; step <= 2; ++step) {
    StepData data;
    data.displacement.assign(garment.placed.size(), mesh::Vec3::Zero());
    for (const std::string& name : names)
      for (const mesh::Vec3& node : garment.placed) data.nodal[name].push_back(0.02 * node.z() * step);
    data.element["stretch_wale"] = std::vector<double>(static_cast<std::size_t>(garment.elements()), 1.25);
    data.global = {{"residual", 1e-9 / step}, {"strain_energy", 1234.5}};
    writer.write_step(step, data);
  }
  write("pressure-levels.csv",
        "level,height [mm],mean pressure [kPa],mean pressure [mmHg],error of the mean pressure [kPa],its part by mesh "
        "[kPa]\n"
        "\"B, ankle\",30,1.357,10.18,0.0421,0.0312\n");
  write("pressure-points.csv", "point,pressure [kPa],its error [kPa]\nheel,2.468,0.135\n");
  write("run.json", R"({"format": "toile run 1", "title": "A sleeve <b>", "end": "reached", "failure": "", "steps": 2,
    "warnings": ["fabric </script> is slack"], "notes": [], "checks": [], "nodes": 1, "unknowns": 1, "body": "a cylinder",
    "used": [], "left out": [], "panels": [], "fabrics": [], "scene": {"scene > Materials > jersey > mu": "0.0617"}})");
}

void Example::write(const std::string& name, const std::string& text) const {
  std::ofstream(folder.file(name)) << text;
}

std::string Example::report() const {
  write_report(results(), page());
  return result::test::read_text(page());
}

}  // namespace toile::report::test
