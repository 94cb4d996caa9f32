#include "pressure_line.hpp"

#include <cmath>
#include <optional>
#include <sstream>

#include "skin_curve.hpp"
#include "straighten.hpp"
#include "toile/base/error.hpp"
#include "toile/body/section.hpp"

namespace toile::scene {

namespace {

using base::Range;
using base::Spec;
using solve::Vec3;

constexpr double near_skin = 20.0;  // mm
constexpr const char* no_smooth_surface =
    "where the body has no smooth surface: a groove or slit is too narrow for one, or the facets are too rough";
constexpr double fine = 1.0;  // mm; between the points of which a line is made

std::string text_of(const Vec3& point) {
  std::ostringstream text;
  text << "(" << point.x() << ", " << point.y() << ", " << point.z() << ")";
  return text.str();
}

std::vector<Vec3> points_of(const base::List& entry, const std::string& parameter) {
  const base::Reals& numbers = entry.reals(parameter);
  if (numbers.size() % 3 != 0)
    entry.fail(parameter, "found " + std::to_string(numbers.size()) + " numbers, expected x, y, z of each point");
  std::vector<Vec3> points;
  for (size_t i = 0; i < numbers.size(); i += 3) points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  return points;
}

Vec3 point_of(const base::List& entry, const std::string& parameter) {
  const std::vector<Vec3> points = points_of(entry, parameter);
  if (points.size() != 1)
    entry.fail(parameter, "found " + std::to_string(points.size()) + " points, expected one: x, y, z or a landmark");
  return points.front();
}

/// The lines of a scene are found on one mesh of the body.
class LineReader {
 public:
  LineReader(const body::Surface& surface, const Output& output)
      : surface_(surface), output_(output), skin_(surface.triangles(output.body_size.value_or(formula_body_size))) {}

  PressureLine read(const base::List& entry) const {
    const std::string& type = entry.word("type");
    if (type == "shortest way") return on_skin(entry, "through", way_through(entry));
    if (type == "cut") return on_skin(entry, "at", cut(entry));
    return on_skin(entry, "height", level(entry));
  }

 private:
  std::vector<Vec3> way_through(const base::List& entry) const {
    std::vector<Vec3> points = points_of(entry, "through"), way;
    if (points.size() < 2) entry.fail("through", "found 1 point, expected at least 2");
    for (Vec3& point : points) point = place_on_body(entry, "through", point, &surface_).place;
    for (size_t i = 1; i < points.size(); ++i) {
      if ((points[i] - points[i - 1]).norm() < fine) continue;
      const std::vector<Vec3> part = shortest_way(entry, points[i - 1], points[i], i);
      way.insert(way.end(), part.begin(), part.end());
    }
    if (way.empty()) entry.fail("through", "its points lie at one place of the body");
    return way;
  }

  std::vector<Vec3> shortest_way(const base::List& entry, const Vec3& from, const Vec3& to, size_t number) const {
    const std::string points = "its points " + std::to_string(number) + " and " + std::to_string(number + 1);
    const std::vector<Vec3> facets = skin_.shortest_way(from, to);
    if (facets.empty())
      entry.fail("through", "no way on the body joins " + points + ", which lie on different pieces of it");
    std::vector<Vec3> way = straightened(surface_, facets, fine);
    if (way.empty())
      entry.fail("through", "the way between " + points +
                                " cannot be drawn tight on the body; give points between them, or a \"cut\"");
    return way;
  }

  std::vector<Vec3> cut(const base::List& entry) const {
    const Vec3 at = point_of(entry, "at"), normal = point_of(entry, "normal");
    if (normal.norm() == 0.0) entry.fail("normal", "must not be zero");
    if (entry.given("from")) return cut(entry, "at", at, normal, point_of(entry, "from"));
    const body::SurfacePoint there = surface_.closest(at);
    if (!there.found || std::abs(there.gap) > near_skin)
      entry.fail("at", text_of(at) + " does not lie on the body's skin, so it does not say where the line starts; " +
                           "give \"from\", a point to whose side it does");
    return cut(entry, "at", at, normal, at);
  }

  std::vector<Vec3> level(const base::List& entry) const {
    const double height = entry.real("height");
    const Vec3 from = point_of(entry, "from");
    if (output_.bent_axis) {
      const mesh::BentAxis::Place place = output_.bent_axis->at(height);
      return cut(entry, "height", place.point, place.direction, from);
    }
    const Vec3 direction = output_.axis_direction.normalized();
    return cut(entry, "height", output_.axis_point + height * direction, direction, from);
  }

  std::vector<Vec3> cut(const base::List& entry, const std::string& parameter, const Vec3& at, const Vec3& normal,
                        const Vec3& from) const {
    std::vector<body::SectionPiece> pieces = skin_.cut(at, normal);
    if (pieces.empty()) entry.fail(parameter, "the plane through " + text_of(at) + " misses the body");
    std::optional<Vec3> to;
    if (entry.given("to")) to = point_of(entry, "to");
    const std::vector<Vec3> way = way_on_section(nearest_piece(std::move(pieces), from), normal, from, to);
    if (way.empty()) entry.fail("to", "the line would end where it starts; left out, it runs round the body");
    return way;
  }

  /// A way on the facets becomes one on the smooth surface, whose length counts.
  PressureLine on_skin(const base::List& entry, const std::string& parameter, const std::vector<Vec3>& facets) const {
    const auto onto = [&](const Vec3& point) {
      const body::SurfacePoint there = surface_.closest(point);
      if (!there.found)
        entry.fail(parameter, "the line passes " + text_of(point) + ", " + no_smooth_surface + ". Lead it past there");
      return BodyPoint{entry.name(), there.closest, there.normal};
    };
    std::vector<Vec3> way;
    for (const Vec3& point : resampled(facets, fine)) way.push_back(onto(point).place);
    const std::vector<double> lengths = lengths_along(way);
    if (lengths.back() < fine) entry.fail(parameter, "its points lie at one place of the body");
    PressureLine line{entry.name(), {}, {}};
    const int stations = entry.integer("stations");
    for (int s = 0; s < stations; ++s) {
      line.lengths.push_back(lengths.back() * s / (stations - 1));
      line.places.push_back(onto(point_at(way, lengths, line.lengths.back())));
    }
    return line;
  }

  const body::Surface& surface_;
  const Output& output_;
  body::Sections skin_;
};

/// `without`: what a missing "from" means.
Spec with_ends(Spec spec, const base::Value& from, const std::string& without) {
  return spec
      .reals("from", "mm",
             "Point x, y, z, or landmark: the line starts at its place that is closest to it, on the skin or far off." +
                 without,
             from)
      .reals("to", "mm",
             "Point x, y, z, or landmark: the line ends at its place that is closest to it. Left out: it runs round, "
             "or from end to end where the body is open.",
             base::Reals{});
}

}  // namespace

Spec lines_spec() {
  Spec way("shortest way", "The shortest way on the skin from each point to the next.");
  way.reals("through", "mm",
            "Points x, y, z, x, y, z, ... within 20 mm of the body's skin, or landmarks on it; at least 2. A line that "
            "ends in its first point runs round.");
  Spec cut("cut", "Where a plane cuts the skin; of several curves the one closest to \"from\".");
  cut.reals("at", "mm", "Point x, y, z of the plane, or landmark.")
      .reals("normal", "", "Across the plane; seen against it the line runs counter-clockwise.");
  Spec level("level",
             "Where the plane across the axis of heights (axis point and direction, or axis) cuts the skin; of several "
             "curves the one closest to \"from\".");
  level.real("height", "mm", "Along that axis, or the landmark of the body that lies there.");
  Spec line("line", "A line on the body.");
  line.variant("type", "How the line is found.",
               {way, with_ends(cut, base::Reals{}, " Left out: \"at\", which then lies within 20 mm of the skin."),
                with_ends(level, base::required, "")})
      .integer("stations", "Places at which the pressure is told, at equal distances along the line.", 101,
               Range::between(2, 10000));
  return Spec("Lines",
              "Lines on the body, along which the pressure of whatever fabric lies there is told (pressure-lines.csv) "
              "and drawn. They are found on the triangles that show the body, or that its file holds; their lengths "
              "are those on the smooth surface.")
      .entries(line);
}

BodyPoint place_on_body(const base::List& entry, const std::string& parameter, const Vec3& point,
                        const body::Surface* surface) {
  if (surface == nullptr) entry.fail(parameter, "the scene has no list \"Body\", so there is no pressure");
  const body::SurfacePoint there = surface->closest(point);
  if (!there.found && std::abs(there.gap) <= surface->range())
    entry.fail(parameter, text_of(point) + " lies " + no_smooth_surface + ". Choose a point beside it");
  std::ostringstream text;
  if (!there.found || std::abs(there.gap) > near_skin) {
    text << text_of(point) << " lies "
         << (there.found ? std::to_string(std::lround(std::abs(there.gap))) + " mm" : std::string("far"))
         << " from the body's skin; allowed are points within " << near_skin
         << " mm of it, or landmarks on it (left bust point; not bust, which lies in the middle of the body)";
    entry.fail(parameter, text.str());
  }
  return {entry.name(), there.closest, there.normal};
}

std::vector<PressureLine> read_lines(const base::List& list, const body::Surface* surface, const Output& output) {
  std::vector<PressureLine> lines;
  const std::vector<base::List> entries = list.entries();
  if (entries.empty()) return lines;
  if (surface == nullptr) entries.front().fail("type", "the scene has no list \"Body\", so there is no pressure");
  std::optional<LineReader> reader;
  try {
    reader.emplace(*surface, output);
  } catch (const base::InputError& error) {
    entries.front().fail("type", error.what());
  }
  for (const base::List& entry : entries) lines.push_back(reader->read(entry));
  return lines;
}

}  // namespace toile::scene
