#include <cmath>

#include "shape.hpp"
#include "toile/base/error.hpp"

namespace toile::garment {
namespace {

using pattern::Curve;
using pattern::Vec2;

std::vector<Vec2> read_points(const base::List& list, std::size_t least, std::size_t most) {
  const base::Reals& values = list.reals("points");
  const std::size_t count = values.size() / 2;
  if (values.size() % 2 != 0 || count < least || count > most) {
    list.fail("points", "has " + std::to_string(values.size()) + " numbers; allowed are pairs x, y: " +
                            (least == most ? std::to_string(least) : "at least " + std::to_string(least)) + " of them");
  }
  std::vector<Vec2> points;
  for (std::size_t k = 0; k < count; ++k) {
    points.emplace_back(values[2 * k], values[2 * k + 1]);
    if (k > 0 && points[k] == points[k - 1])
      list.fail("points", "repeats its point number " + std::to_string(k) + "; each must differ from the one before");
  }
  return points;
}

Curve read_line(const base::List& list) {
  const auto p = read_points(list, 2, 2);
  return Curve::line(p[0], p[1]);
}
Curve read_polyline(const base::List& list) {
  return Curve::polyline(read_points(list, 2, 100000));
}
Curve read_spline(const base::List& list) {
  return Curve::spline(read_points(list, 2, 100000));
}
Curve read_quadratic(const base::List& list) {
  const auto p = read_points(list, 3, 3);
  return Curve::quadratic(p[0], p[1], p[2]);
}
Curve read_cubic(const base::List& list) {
  const auto p = read_points(list, 4, 4);
  return Curve::cubic(p[0], p[1], p[2], p[3]);
}
Curve read_arc(const base::List& list) {
  const auto p = read_points(list, 2, 2);
  try {
    return Curve::circular(p[0], p[1], list.real("radius"), list.flag("longer"), list.flag("counter-clockwise"));
  } catch (const base::InputError& error) {
    list.fail("radius", error.what());
  }
}

struct CurveKind {
  base::Spec spec;
  Curve (*read)(const base::List& list);
};

base::Spec curve_spec(const std::string& name, const std::string& text, const std::string& points) {
  return base::Spec(name, text).reals("points", "mm", points);
}

const std::vector<CurveKind>& curve_kinds() {
  static const std::vector<CurveKind> all{
      {curve_spec("line", "Straight.", "x, y of both ends."), read_line},
      {curve_spec("polyline", "Straight lines from point to point.", "x, y of two points or more."), read_polyline},
      {curve_spec("spline", "Natural cubic spline.", "x, y of two points or more."), read_spline},
      {curve_spec("quadratic", "Quadratic Bezier curve.", "x, y of one end, the control point, the other end."),
       read_quadratic},
      {curve_spec("cubic", "Cubic Bezier curve.", "x, y of one end, two control points, the other end."), read_cubic},
      {curve_spec("arc", "Arc of a circle.", "x, y of both ends.")
           .real("radius", "mm", "Of the circle.", base::required, base::Range::positive())
           .flag("longer", "The longer way round the circle.", false)
           .flag("counter-clockwise", "From the first end to the second.", true),
       read_arc}};
  return all;
}

base::Spec any_curve(const std::string& name, const std::string& text) {
  base::Spec spec(name, text);
  std::vector<base::Spec> variants;
  for (const CurveKind& kind : curve_kinds()) variants.push_back(kind.spec);
  spec.variant("curve", "Kind of curve.", variants, std::string("line"));
  return spec;
}

Curve read_curve(const base::List& list) {
  for (const CurveKind& kind : curve_kinds())
    if (kind.spec.name() == list.word("curve")) return kind.read(list);
  throw base::Error(base::ExitCode::internal_error, "a kind of curve is declared and not read");
}

pattern::Loop read_loop(const base::List& list) {
  pattern::Loop loop;
  for (const base::List& entry : list.entries()) loop.push_back({entry.name(), read_curve(entry)});
  return loop;
}

base::Spec loops_spec() {
  base::Spec hole("hole", "Edges of one hole, one after another.");
  hole.entries(any_curve("edge", "One edge of the hole."), 1);
  base::Spec spec("Holes", "Holes in the panel: a buttonhole, the neck of a piece that is cut in one.");
  spec.entries(hole);
  return spec;
}

base::Spec outline_spec() {
  base::Spec outline("Outline",
                     "Edges of the panel, one after another round it, each from where the one before ends; the name of "
                     "each entry is the name of the edge.");
  outline.entries(any_curve("edge", "One edge of the panel."), 1);
  base::Spec lines("Lines", "Lines inside the panel, along which the sides of elements lie: darts, pleats, zones.");
  lines.entries(any_curve("line", "One line."));
  base::Spec notch("notch", "A mark on an edge, by which parts of edges are named.");
  notch.word("on", "Name of an edge.")
      .real("at", "", "Relative arc length along the edge.", base::required, base::Range::between(0.0, 1.0));
  base::Spec notches("Notches", "Marks on the edges.");
  notches.entries(notch);
  base::Spec spec("outline", "A closed line of named curves, with holes, lines and notches.");
  spec.word("cut on fold", "Name of a straight edge: the panel goes on beyond it as its mirror image.", std::string())
      .list(outline, true)
      .list(loops_spec())
      .list(lines)
      .list(notches);
  return spec;
}

Cut read_outline(const base::List& panel) {
  Cut cut;
  cut.panel.name = panel.name();
  cut.panel.outline = read_loop(panel.list("Outline"));
  if (panel.has_list("Holes"))
    for (const base::List& hole : panel.list("Holes").entries()) cut.panel.holes.push_back(read_loop(hole));
  if (panel.has_list("Lines"))
    for (const base::List& line : panel.list("Lines").entries())
      cut.panel.lines.push_back({line.name(), read_curve(line)});
  if (panel.has_list("Notches"))
    for (const base::List& notch : panel.list("Notches").entries())
      cut.panel.notches.push_back({notch.name(), notch.word("on"), notch.real("at")});
  const std::string& fold = panel.word("cut on fold");
  if (fold.empty()) return cut;
  try {
    cut.panel = pattern::unfolded(cut.panel, fold);
  } catch (const base::InputError& error) {
    panel.fail("cut on fold", error.what());
  }
  return cut;
}

}  // namespace

Shape outline_shape() {
  return {outline_spec(), read_outline, true};
}

}  // namespace toile::garment
