#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "flat_faces.hpp"
#include "import_checks.hpp"
#include "toile/base/error.hpp"
#include "toile/body/body.hpp"
#include "toile/body/import.hpp"
#include "toile/body/level_set.hpp"

namespace toile::body {
namespace {

using base::List;

Span read_span(const List& list) {
  const Span span{list.real("bottom"), list.real("top")};
  if (span.top <= span.bottom) {
    list.fail("top", "must be above bottom");
  }
  return span;
}

/// Revolution of a spline that is known to be positive at its levels only: between and beyond them it may undershoot.
/// `parameter` is the one to blame.
SurfacePtr positive_revolution(const List& list, const std::string& parameter, const ProfilePtr& profile,
                               const Span& levels, const Span& shown, const std::string& name) {
  constexpr int samples = 1000;
  const double lower = std::min(levels.bottom, shown.bottom), upper = std::max(levels.top, shown.top);
  for (int i = 0; i <= samples; ++i) {
    const double z = lower + (upper - lower) * i / samples;
    const double radius = profile->at(z).radius;
    if (radius <= 0.0) {
      std::ostringstream text;
      text << "the smooth curve through these values has the radius " << radius << " mm at the height " << z
           << " mm; give more levels there, or values that change less abruptly";
      list.fail(parameter, text.str());
    }
  }
  return revolution(profile, shown, name);
}

SurfacePtr make_leg(const List& list) {
  const std::array<std::string, 4> names{"ankle", "calf", "knee", "thigh"};
  std::vector<double> levels, radii;
  for (const std::string& name : names) {
    if (!levels.empty() && list.real(name + " level") <= levels.back()) {
      list.fail(name + " level", "must be above the level before it (ankle, calf, knee, thigh)");
    }
    levels.push_back(list.real(name + " level"));
    radii.push_back(list.real(name + " girth") / (2.0 * M_PI));
  }
  const std::string& narrowest = names[std::min_element(radii.begin(), radii.end()) - radii.begin()];
  return positive_revolution(list, narrowest + " girth", spline_profile(levels, radii, LowerEnd::mirrored),
                             {levels.front(), levels.back()}, read_span(list), "leg");
}

SurfacePtr make_profile(const List& list) {
  const auto& levels = list.reals("levels");
  if (levels.size() < 2 || std::adjacent_find(levels.begin(), levels.end(), std::greater_equal<>()) != levels.end()) {
    list.fail("levels", "needs two or more heights in increasing order");
  }
  if (list.reals("radii").size() != levels.size()) {
    list.fail("radii", "needs one radius for each of the " + std::to_string(levels.size()) + " levels");
  }
  const Span span{levels.front(), levels.back()};
  return positive_revolution(list, "radii", spline_profile(levels, list.reals("radii")), span, span, "profile");
}

Vec3 read_point(const List& list, const std::string& name) {
  const auto& values = list.reals(name);
  if (values.size() != 3) {
    list.fail(name, "needs three values x, y, z");
  }
  return {values[0], values[1], values[2]};
}

Region read_reach(const List& list) {
  Region region;
  region.lower.z() = list.real("bottom");
  region.upper.z() = list.real("top");
  if (list.given("lower corner")) {
    region.lower = region.lower.cwiseMax(read_point(list, "lower corner"));
  }
  if (list.given("upper corner")) {
    region.upper = region.upper.cwiseMin(read_point(list, "upper corner"));
  }
  if (list.given("seed")) {
    region.seed = read_point(list, "seed");
  }
  return region;
}

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

SurfacePtr make_imported(const List& list, const Region* region, BodyFindings* findings) {
  namespace fs = std::filesystem;
  if (list.word("surface") == "facets") {
    list.fail("surface",
              "bare facets are refused: without friction, fabric comes to rest on the edges between them, where the "
              "normal jumps, so that no iteration converges; \"smooth\" fits a surface without edges to them");
  }
  const std::string file = (fs::path(list.file("file")).parent_path() / list.word("file")).lexically_normal().string();
  Region reach;
  std::string source;
  if (list.has_list("Reach")) {
    reach = read_reach(list.list("Reach"));
    source = " (list Reach)";
  } else if (region != nullptr) {
    reach = *region;
    source = " of the panels";
  }
  ImportOptions options = read_import_options(list);
  options.reach = reach;
  Import import = import_body(file, options);
  const double chord = split_long_triangles(&import.mesh);
  const std::size_t all = import.mesh.triangles.size();
  TriangleMesh mesh = clip(import.mesh, reach);
  if (mesh.triangles.empty()) {
    list.fail("file", "no triangle of the body lies where the garment can reach; see the list Reach");
  }
  BodyFindings found = look_at(list, import, mesh);
  if (chord > deep_chord) {
    found.warnings.push_back(turned_strips_text(chord));
  }
  if (findings != nullptr) {
    *findings = found;
  }
  std::string name = fs::path(file).filename().string() + ": " + shown_extents(import.extents) + " mm, " +
                     std::to_string(mesh.triangles.size()) + " of " + std::to_string(all) + " triangles in reach" +
                     source;
  if (!import.notes.empty()) {
    name += ", " + import.notes;
  }
  try {
    return level_set(std::move(mesh), {list.real("cell"), list.real("smoothing")}, name);
  } catch (const base::InputError& error) {
    list.fail("cell", error.what());
  }
}

SurfacePtr make_cone(const List& list) {
  const Span span = read_span(list);
  const double radius = list.real("radius");
  const double slope = list.real("slope");
  if (radius + slope * span.bottom <= 0.0 || radius + slope * span.top <= 0.0) {
    list.fail("slope", "the radius must stay positive between bottom and top");
  }
  return revolution(linear_profile(radius, slope), span, "cone");
}

SurfacePtr make_cosine(const List& list) {
  if (std::abs(list.real("amplitude")) >= list.real("radius")) {
    list.fail("amplitude", "its magnitude must be smaller than the radius");
  }
  return revolution(cosine_profile(list.real("radius"), list.real("amplitude"), list.real("period")), read_span(list),
                    "cosine body of revolution");
}

}  // namespace

SurfacePtr make_surface(const List& list, const Region* region, BodyFindings* findings) {
  const std::string& type = list.word("type");
  if (type == "leg") return make_leg(list);
  if (type == "cylinder") return revolution(linear_profile(list.real("radius"), 0.0), read_span(list), "cylinder");
  if (type == "elliptic cylinder") return elliptic_cylinder(list.real("a"), list.real("b"), read_span(list));
  if (type == "cone") return make_cone(list);
  if (type == "ellipsoid") return ellipsoid(list.real("radius"), list.real("half height"));
  if (type == "sphere") return ellipsoid(list.real("radius"), list.real("radius"));
  if (type == "cosine") return make_cosine(list);
  if (type == "profile") return make_profile(list);
  return make_imported(list, region, findings);
}

}  // namespace toile::body
