#include <cmath>
#include <filesystem>
#include <sstream>

#include "file_kind.hpp"
#include "fitted.hpp"
#include "flat_faces.hpp"
#include "import_checks.hpp"
#include "toile/base/error.hpp"
#include "toile/body/import.hpp"
#include "toile/body/landmarks.hpp"

namespace toile::body {
namespace {

using base::List;

ImportOptions read_import_options(const List& list) {
  ImportOptions options;
  options.scale = list.real("scale");
  const auto& heights = list.reals("height range");
  if (heights.size() != 2 || heights[0] >= heights[1]) {
    list.fail("height range", "needs two values, the least and the greatest height");
  }
  options.least_height = heights[0];
  options.greatest_height = heights[1];
  options.closed = list.flag("closed");
  options.repair_orientation = list.flag("repair orientation");
  options.weld = list.real("weld");
  const std::string& up = list.word("up");
  options.up = up == "x" ? Axis::x : up == "y" ? Axis::y : Axis::z;
  options.up_is_known = list.given("up") || list.given("height range");
  return options;
}

std::string path_of(const List& list) {
  namespace fs = std::filesystem;
  return (fs::path(list.file("file")).parent_path() / list.word("file")).lexically_normal().string();
}

/// Refuses a body of flat faces that nothing rounds; returns what else is suspicious of the part in reach.
BodyFindings look_at(const List& list, const Import& import, const TriangleMesh& mesh) {
  BodyFindings findings;
  findings.scale = list.real("scale");
  findings.height = import.extents.z();
  if (list.given("scale") && !list.given("height range")) {
    findings.person = person_in_another_unit(findings.height, findings.scale);
  }
  const FlatFaces faces = find_flat_faces(mesh);
  if (prevail(faces)) {
    list.fail("file", flat_faces_text(faces));
  }
  if (matter(faces)) {
    findings.warnings.push_back(flat_faces_text(faces));
  }
  return findings;
}

constexpr double deep_chord = 0.2;  // mm inside the body

std::string turned_strips_text(double chord) {
  std::ostringstream text;
  text.precision(2);
  text << "the body is made of strips that turn along their length: their edges are chords, which lie up to " << chord
       << " mm inside the round body, and so does the surface that the fabric meets. Pressures change round the body "
          "and "
          "are too low; export it with a tolerance of 0.1 mm or with more vertices along the strips";
  return text.str();
}

}  // namespace

Landmarks landmarks_of(const List& list) {
  if (list.word("type") == "mannequin") {
    return landmarks_of_mannequin(list);
  }
  if (list.word("type") != "file") {
    list.fail("type",
              "landmarks are found on bodies from files and on mannequins; on one that is given by a formula give "
              "numbers");
  }
  return find_landmarks(import_body(path_of(list), read_import_options(list)).mesh, path_of(list));
}

SurfacePtr make_from_file(const List& list, const Region* region, BodyFindings* findings) {
  namespace fs = std::filesystem;
  if (list.word("surface") == "facets") {
    list.fail("surface",
              "bare facets are refused: without friction, fabric comes to rest on the edges between them, where the "
              "normal jumps, so that no iteration converges; \"smooth\" fits a surface without edges to them");
  }
  const std::string file = path_of(list);
  const Reach reach = read_reach(list, region);
  ImportOptions options = read_import_options(list);
  options.reach = reach.region;
  Import import = import_body(file, options);
  const double chord = split_long_triangles(&import.mesh);
  const std::size_t all = import.mesh.triangles.size();
  TriangleMesh mesh = clip(import.mesh, reach.region);
  check_in_reach(list, "file", mesh);
  BodyFindings found = look_at(list, import, mesh);
  if (chord > deep_chord) {
    found.warnings.push_back(turned_strips_text(chord));
  }
  if (findings != nullptr) {
    *findings = found;
  }
  std::string name = fs::path(file).filename().string() + ": " + shown_extents(import.extents) + " mm, " +
                     std::to_string(mesh.triangles.size()) + " of " + std::to_string(all) + " triangles in reach" +
                     reach.source;
  if (!import.notes.empty()) {
    name += ", " + import.notes;
  }
  return fit_surface(list, std::move(mesh), name);
}

}  // namespace toile::body
