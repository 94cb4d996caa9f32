// List "Supports": where the garment is held, moved and turned.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "equilibrium/limb_directions.hpp"
#include "input/read.hpp"
#include "toile/solve/spec.hpp"

namespace toile::solve {

using base::List;
using base::Spec;

Spec supports_spec() {
  Spec support("support", "Nodes that are held in some directions.");
  support
      .words("on",
             "Names of edges (for instance front.top), of whole panels (front), of corners (front.top-left), or of one "
             "node: at a relative place on an edge (front.top@0.5) or in a panel (front@0.5 0.25), or nearest to a "
             "point x, y of its pattern in mm (front@(12.5 40)).")
      .choice("hold",
              "Directions that are held; none: only \"director\". direction: along \"direction\"; across direction: in "
              "the plane across it; along the limb: along the body's surface at the start, in the direction of the "
              "limb's axis, so that the nodes stay free round the body and away from it.",
              {"x", "y", "z", "xy", "xz", "yz", "xyz", "none", "direction", "across direction", "along the limb"})
      .reals("direction", "",
             "Of \"hold\" = direction or across direction: x, y, z, of any length. Of along the limb: the limb's axis, "
             "towards its upper end; left out: the axis that the panel is wrapped round.",
             base::Reals{})
      .reals("move by", "mm", "Displacement of the held directions at load 1 (x, y, z).", base::Reals{0.0, 0.0, 0.0})
      .real("move along", "mm", "Of \"hold\" = direction or along the limb: displacement along it at load 1.", 0.0)
      .reals(
          "loads", "",
          "Increasing loads at which \"shares\" says how much of \"move by\" and \"turn by\" has been gone; in between "
          "it goes linearly, before and after it rests. Left out: in step with the load.",
          base::Reals{})
      .reals("shares", "", "Share of the way at each of \"loads\".", base::Reals{})
      .real("turn by", "deg",
            "Rotation about the axis at load 1, right-handed; nodes move on circles, and \"move by\" is added. Held "
            "directors turn with it. All directions must be held; one along the axis may be left free. The torque is "
            "reported (torques.csv).",
            0.0)
      .reals("axis point", "mm", "Point of the axis of \"turn by\", or a landmark of the body.",
             base::Reals{0.0, 0.0, 0.0})
      .reals("axis direction", "", "Direction of that axis.", base::Reals{0.0, 0.0, 1.0})
      .choice("director",
              "Of shells: free (a hinge), held (a clamp: the panel keeps its direction), symmetry (the panel stays "
              "perpendicular to the plane of symmetry, whose normal is each held direction), or diaphragm (a hinge on "
              "a rigid plate: the panel turns about its edge but does not twist along it).",
              {"free", "held", "symmetry", "diaphragm"}, std::string("free"));
  return Spec("Supports", "Where the garment is held.").entries(support);
}

namespace {

/// Turning nodes about an axis moves them in every direction across it, so these must be held.
void check_held_across(const List& entry, const Support& support) {
  constexpr double along = 1.0 - 1e-12;
  std::string allowed = "\"xyz\"";
  bool is_held = true;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto is_along_axis = [&](const Vec3& direction) {
      return std::abs(support.turn->axis.dot(direction)) >= along;
    };
    is_held = is_held && (support.held[static_cast<size_t>(i)] || is_along_axis(support.axis(0, i)));
    if (is_along_axis(Vec3::Unit(i))) allowed += " or \"" + std::string("xyz").erase(static_cast<size_t>(i), 1) + "\"";
  }
  if (entry.given("direction")) allowed += " or \"across direction\" with the direction of the axis";
  if (!is_held)
    entry.fail("turn by", "turns nodes on circles about the axis, but \"hold\" is \"" + entry.word("hold") +
                              "\", which leaves them free across it; allowed here: " + allowed);
}

void read_turn(const List& entry, Support& support) {
  if (!entry.given("turn by")) {
    for (const char* name : {"axis point", "axis direction"})
      if (entry.given(name)) entry.fail(name, "nothing turns: give \"turn by\" as well, or leave this out");
    return;
  }
  const Vec3 direction = read_vector(entry, "axis direction");
  if (direction.norm() == 0.0) entry.fail("axis direction", "must not be zero");
  support.turn = Turn{read_vector(entry, "axis point"), direction.normalized(), entry.real("turn by") * M_PI / 180.0};
  check_held_across(entry, support);
  if (support.director != DirectorSupport::free && support.director != DirectorSupport::held)
    entry.fail("director",
               "a plane of symmetry or a diaphragm does not turn: with \"turn by\" it must be \"free\" or \"held\"");
}

MotionPath read_path(const List& support) {
  MotionPath path{support.reals("loads"), support.reals("shares")};
  if (path.loads.size() != path.shares.size())
    support.fail("shares", "found " + std::to_string(path.shares.size()) + " values, but \"loads\" has " +
                               std::to_string(path.loads.size()) + "; there must be one share for each load");
  if (path.loads.size() == 1) support.fail("loads", "found a single load; a path needs two or more");
  for (size_t k = 1; k < path.loads.size(); ++k)
    if (path.loads[k] <= path.loads[k - 1])
      support.fail("loads", "must increase strictly, but value number " + std::to_string(k + 1) + " does not");
  return path;
}

/// Axes of the support whose first one is along "direction".
Frame axes_of(const List& entry) {
  if (!entry.given("direction"))
    entry.fail("direction", "is missing: \"hold\" = \"" + entry.word("hold") + "\" needs it (x, y, z)");
  const Vec3 direction = read_vector(entry, "direction");
  if (direction.norm() == 0.0) entry.fail("direction", "must not be zero");
  Eigen::Index smallest = 0;
  direction.cwiseAbs().minCoeff(&smallest);
  const Vec3 first = direction.normalized(), second = first.cross(Vec3::Unit(smallest)).normalized();
  Frame axes;
  axes << first.transpose(), second.transpose(), first.cross(second).transpose();
  return axes;
}

/// Held directions, the support's axes, and how far they move.
void read_hold(const List& entry, const Problem& problem, Support& s) {
  const std::string& hold = entry.word("hold");
  const bool limb = hold == "along the limb", one = hold == "direction" || limb, across = hold == "across direction";
  if (one || across) {
    s.held = {one, across, across};
    s.axes = limb ? limb_directions(entry, problem, s.nodes) : std::vector<Frame>(s.nodes.size(), axes_of(entry));
  } else {
    for (const char* name : {"direction", "move along"})
      if (entry.given(name))
        entry.fail(name, std::string("goes with \"hold\" = \"direction\"") +
                             (std::string(name) == "direction" ? ", \"across direction\"" : "") +
                             " or \"along the limb\", but \"hold\" is \"" + hold + "\"");
    for (size_t i = 0; i < 3; ++i) s.held[i] = hold != "none" && hold.find("xyz"[i]) != std::string::npos;
  }
  const Vec3 by = read_vector(entry, "move by");
  if (one) {
    if (entry.given("move by"))
      entry.fail("move by", "goes with x, y and z; \"hold\" = \"" + hold + "\" moves by \"move along\"");
    s.displacement[0] = entry.real("move along");
    return;
  }
  if (across && entry.given("move along"))
    entry.fail("move along", "\"across direction\" leaves the nodes free along it; give \"move by\"");
  if (!across) {
    s.displacement = by;
    for (int i = 0; i < 3; ++i)
      if (by[i] != 0.0 && !s.held[i])
        entry.fail("move by", std::string("moves in ") + "xyz"[i] + ", but \"hold\" is \"" + hold + "\"");
    return;
  }
  constexpr double none = 1e-6;
  s.displacement = s.axes.front() * by;
  if (std::abs(s.displacement[0]) > none * by.norm())
    entry.fail("move by", "has a part along \"direction\", in which \"across direction\" leaves the nodes free");
}

DirectorSupport read_director(const List& entry, const Support& support) {
  const std::string &director = entry.word("director"), &hold = entry.word("hold");
  const DirectorSupport read = director == "held"        ? DirectorSupport::held
                               : director == "symmetry"  ? DirectorSupport::symmetry
                               : director == "diaphragm" ? DirectorSupport::diaphragm
                                                         : DirectorSupport::free;
  const auto held = std::count(support.held.begin(), support.held.end(), true);
  if (read == DirectorSupport::diaphragm && held != 2)
    entry.fail(
        "director",
        "\"diaphragm\" needs the two held directions of its plane (xy, xz, yz or across direction), but \"hold\" "
        "is \"" +
            hold + "\"");
  if (held == 0 && read != DirectorSupport::held)
    entry.fail("hold", "holds nothing: name a direction, or hold the director of a shell (\"director\" = held)");
  return read;
}

}  // namespace

std::vector<Support> read_supports(const List& list, const Problem& problem) {
  std::vector<Support> supports;
  for (const List& entry : list.entries()) {
    Support s;
    s.name = entry.name();
    if (entry.words("on").empty()) entry.fail("on", "names no edge and no panel");
    for (const std::string& set : entry.words("on")) {
      const std::vector<int> nodes = read_nodes(entry, *problem.mesh, set);
      s.nodes.insert(s.nodes.end(), nodes.begin(), nodes.end());
    }
    read_hold(entry, problem, s);
    s.path = read_path(entry);
    s.director = read_director(entry, s);
    read_turn(entry, s);
    supports.push_back(s);
  }
  return supports;
}

}  // namespace toile::solve
