#include "zones.hpp"

#include <cmath>
#include <limits>

#include "toile/base/error.hpp"
#include "toile/mesh/zones.hpp"
#include "toile/pattern/area.hpp"

namespace toile::garment {
namespace {

using mesh::Vec2;

std::vector<base::List> zones_of(const base::List& panel) {
  return panel.has_list("Zones") ? panel.list("Zones").entries() : std::vector<base::List>();
}

std::vector<Vec2> read_border(const base::List& zone) {
  const base::Reals& values = zone.reals("border");
  if (values.size() < 6 || values.size() % 2 != 0)
    zone.fail("border", "has " + std::to_string(values.size()) +
                            " numbers; allowed are pairs x, y, and at least three of them, the corners of the zone");
  std::vector<Vec2> corners;
  for (std::size_t k = 0; k < values.size(); k += 2) corners.emplace_back(values[k], values[k + 1]);
  return corners;
}

pattern::Area read_band(const base::List& zone, const pattern::Panel& panel) {
  const base::Reals& heights = zone.reals("band");
  if (heights.size() != 2 || !(heights[0] < heights[1]))
    zone.fail("band", "needs two numbers, the lowest y of the zone and the highest");
  return pattern::band(panel, zone.name(), heights[0], heights[1]);
}

/// Zones that are drawn, and not given by a point between lines.
std::vector<pattern::Area> read_areas(const base::List& panel, const pattern::Panel& outline) {
  std::vector<pattern::Area> areas;
  for (const base::List& zone : zones_of(panel)) {
    if (zone.given("border"))
      areas.push_back({zone.name(), read_border(zone)});
    else if (zone.given("band"))
      areas.push_back(read_band(zone, outline));
  }
  return areas;
}

}  // namespace

base::Spec zones_spec() {
  base::Spec zone("zone", "Part of the panel: give one of 'band', 'border' and 'point'.");
  zone.reals("band", "mm", "Lowest and highest y of the pattern: the whole width of the panel between.", base::Reals{})
      .reals("border", "mm",
             "x, y of the corners of the zone in the pattern, one after another round it. It may go beyond the panel; "
             "what lies outside is left out.",
             base::Reals{})
      .reals("point", "mm", "Any place x, y of the pattern inside the zone, which goes as far as the internal lines.",
             base::Reals{})
      .word("material", "Name of an entry of the list Materials; empty: that of the panel.", std::string())
      .real("wale angle", "deg",
            "Angle from the pattern's x axis to the wale direction; if it is left out, that of the panel.",
            std::numeric_limits<double>::quiet_NaN());
  base::Spec spec("Zones",
                  "Parts of the panel that are made of another fabric, or of the same in another direction. Sides of "
                  "elements lie along their borders, for which the panel is meshed freely.");
  spec.entries(zone);
  return spec;
}

void add_borders(const base::List& panel, Cut& cut) {
  for (const base::List& zone : zones_of(panel)) {
    const int given = (zone.given("band") ? 1 : 0) + (zone.given("border") ? 1 : 0) + (zone.given("point") ? 1 : 0);
    if (given != 1)
      zone.fail("point", std::string(given == 0 ? "is not given, and neither are \"band\" and \"border\""
                                                : "does not go with \"band\" or \"border\", nor these together") +
                             "; a zone needs exactly one of the three");
  }
  const pattern::Panel outline = cut.along_outline();
  const std::vector<pattern::Area> areas = read_areas(panel, outline);
  if (areas.empty()) return;
  if (panel.word("mesher") != "free")
    panel.fail("mesher", "\"" + panel.word("mesher") +
                             "\" has no lines of elements along the borders of zones; zones with \"band\" or "
                             "\"border\" need \"free\"");
  try {
    for (pattern::InternalLine& line : pattern::borders(outline, areas)) cut.panel.lines.push_back(std::move(line));
  } catch (const base::InputError& error) {
    panel.fail("Zones", error.what());
  }
}

std::map<std::string, mesh::ZoneFabric> read_fabrics(const base::List& panel) {
  const auto angle = [](const base::List& list) { return list.real("wale angle") * M_PI / 180.0; };
  const mesh::ZoneFabric whole{panel.word("material"), angle(panel)};
  std::map<std::string, mesh::ZoneFabric> all{{"", whole}};
  for (const base::List& zone : zones_of(panel))
    all[zone.name()] = {zone.word("material").empty() ? whole.material : zone.word("material"),
                        zone.given("wale angle") ? angle(zone) : whole.wale_angle};
  return all;
}

void divide_into_zones(const base::List& panel, const Cut& cut, mesh::PanelMesh& mesh) {
  mesh::ZonePlaces places;
  for (const base::List& zone : zones_of(panel)) {
    if (!zone.given("point")) continue;
    const base::Reals& at = zone.reals("point");
    if (at.size() != 2) zone.fail("point", "needs two numbers, x and y");
    places.points[zone.name()] = {at[0], at[1]};
  }
  for (pattern::Area& area : read_areas(panel, cut.along_outline())) places.borders[area.name] = std::move(area.border);
  std::vector<std::vector<int>> lines;
  for (const pattern::InternalLine& line : cut.panel.lines) lines.push_back(mesh.edges.at(line.name));
  try {
    mesh::divide_into_zones(mesh, lines, places);
  } catch (const base::InputError& error) {
    panel.fail("Zones", error.what());
  }
}

}  // namespace toile::garment
