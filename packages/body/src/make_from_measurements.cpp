#include <cmath>
#include <filesystem>
#include <map>
#include <mutex>
#include <sstream>

#include "file_kind.hpp"
#include "fitted.hpp"
#include "import_checks.hpp"
#include "toile/base/error.hpp"
#include "toile/body/import.hpp"
#include "toile/body/mannequin.hpp"
#include "toile/body/section.hpp"

namespace toile::body {
namespace {

using base::List;

std::map<std::string, double> given_in(const List& list) {
  std::map<std::string, double> given;
  for (const std::string& name : measurement_names()) {
    if (list.given(name)) {
      given[name] = list.real(name);
    }
  }
  return given;
}

std::string source_of(const List& list) {
  namespace fs = std::filesystem;
  if (list.word("from").empty()) {
    return TOILE_MANNEQUIN_BODY;
  }
  return (fs::path(list.file("from")).parent_path() / list.word("from")).lexically_normal().string();
}

/// The given measurement that a message names first; "type" if it names none.
std::string named_in(const List& list, const std::string& message) {
  std::string named = "type";
  std::size_t first = std::string::npos;
  for (const auto& entry : given_in(list)) {
    const std::size_t at = message.find(entry.first + " ");
    if (at < first) {
      first = at;
      named = entry.first;
    }
  }
  return named;
}

Mannequin made(const List& list) {
  MannequinOptions options;
  options.edge = list.real("edge");
  if (list.given("arms")) {
    options.arm_angle = list.real("arms");
  }
  try {
    const auto measurements = complete_measurements(given_in(list));
    return make_mannequin(import_body(source_of(list), ImportOptions()).mesh, measurements, options);
  } catch (const base::InputError& error) {
    list.fail(named_in(list, error.what()), error.what());
  }
}

/// What makes the mannequin that it is.
std::string key_of(const List& list) {
  std::ostringstream key;
  key.precision(17);
  for (const auto& [name, value] : given_in(list)) {
    key << name << ' ' << value << ' ';
  }
  key << list.real("edge") << ' ' << list.given("arms") << ' ' << list.real("arms") << ' ' << source_of(list);
  return key.str();
}

/// Made once for landmarks and surface of a scene.
Mannequin mannequin_of(const List& list) {
  static std::mutex mutex;
  static std::string key;
  static Mannequin last;
  const std::lock_guard<std::mutex> lock(mutex);
  const std::string wanted = key_of(list);
  if (wanted != key) {
    last = made(list);
    key = wanted;
  }
  return last;
}

}  // namespace

Landmarks landmarks_of_mannequin(const List& list) {
  return mannequin_of(list).landmarks;
}

SurfacePtr make_from_measurements(const List& list, const Region* region, BodyFindings* findings) {
  const Reach reach = read_reach(list, region);
  const Mannequin mannequin = mannequin_of(list);
  TriangleMesh mesh = clip(mannequin.mesh, reach.region);
  check_in_reach(list, "type", mesh);
  const Vec3 extents = extent_of(mannequin.mesh).upper - extent_of(mannequin.mesh).lower;
  if (findings != nullptr) {
    *findings = BodyFindings();
    findings->height = extents.z();
  }
  std::ostringstream name;
  name << "mannequin (";
  const char* separator = "";
  for (const Measurement& m : mannequin.measurements) {
    if (m.name == "height" || m.name == "bust" || m.name == "waist" || m.name == "hip") {
      name << separator << m.name << ' ' << std::lround(m.reached);
      separator = ", ";
    }
  }
  name << "): " << shown_extents(extents) << " mm, " << mesh.triangles.size() << " of "
       << mannequin.mesh.triangles.size() << " triangles in reach" << reach.source;
  return fit_surface(list, std::move(mesh), name.str());
}

}  // namespace toile::body
