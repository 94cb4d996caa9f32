#include "leg_scene.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "toile/base/units.hpp"

namespace toile::test {
namespace {

std::vector<double> element_field(const solve::Fields& fields, const std::string& name) {
  std::vector<double> all;
  for (const auto& block : fields.element) {
    const auto field = std::find_if(block.begin(), block.end(), [&](const auto& f) { return f.name == name; });
    all.insert(all.end(), field->values.begin(), field->values.end());
  }
  return all;
}

/// A scene file of this rank alone, so that no rank waits for another; removed with this object.
class SceneFile {
 public:
  SceneFile(const std::string& name, const std::string& content)
      : path_(std::filesystem::temp_directory_path() / (name + "." + std::to_string(getpid()) + ".xml")) {
    std::ofstream(path_) << "<ParameterList name=\"scene\">" << content << "</ParameterList>";
  }
  SceneFile(const SceneFile&) = delete;
  SceneFile& operator=(const SceneFile&) = delete;
  ~SceneFile() { std::filesystem::remove(path_); }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

std::string coarse_panels(const std::string& name) {
  const std::string along = "<Parameter name=\"elements along\" type=\"int\" value=\"96\"/>";
  const std::string across = "<Parameter name=\"elements across\" type=\"int\" value=";
  if (name.find("one-panel") == std::string::npos) return both_panels(along + across + "\"12\"/>");
  return "<ParameterList name=\"Panels\"><ParameterList name=\"leg\">" + along + across +
         "\"24\"/></ParameterList></ParameterList>";
}

base::List read_coarse(const std::string& name, const std::string& more) {
  const SceneFile mesh("leg_mesh", coarse_panels(name));
  const SceneFile scene("leg_scene", "<Parameter name=\"include\" type=\"Array(string)\" value=\"{" +
                                         std::string(TOILE_SOURCE_DIR) + "/input/" + name + ", " + mesh.path() +
                                         "}\"/>" + more);
  return base::read_xml(scene.path(), scene::scene_spec());
}

}  // namespace

std::vector<LegLevel> Leg::levels() const {
  std::vector<LegLevel> found;
  for (const result::LevelRow& row : session->record().pressure().levels)
    found.push_back({base::mpa_to_kpa(row.pressure_mean), base::mpa_to_kpa(row.laplace), row.smallest_stress,
                     base::mpa_to_kpa(row.pressure_error)});
  return found;
}

double Leg::quantile(const std::string& field, double share) const {
  std::vector<double> values = element_field(fields, field);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double Leg::imbalance() const {
  solve::ForceBalance written = report.balance;
  written.contact = solve::contact_resultant(fields);
  return written.sum().norm() / written.magnitude;
}

std::string both_panels(const std::string& parameters) {
  std::string panels;
  for (const std::string name : {"front", "back"})
    panels += "<ParameterList name=\"" + name + "\">" + parameters + "</ParameterList>";
  return "<ParameterList name=\"Panels\">" + panels + "</ParameterList>";
}

Leg run_leg(const std::string& name, const std::string& more) {
  Leg leg;
  leg.session = std::make_unique<run::Session>(read_coarse(name, more));
  leg.scene = &leg.session->scene();
  leg.session->run();
  const run::Record& record = leg.session->record();
  leg.report = record.last();
  leg.state = record.state();
  leg.fields = record.fields();
  return leg;
}

}  // namespace toile::test
