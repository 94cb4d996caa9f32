// List "Supports": where the garment is held, moved and turned.
#include <cmath>

#include "read.hpp"
#include "toile/solve/spec.hpp"

namespace toile::solve {

using base::List;
using base::Spec;

Spec supports_spec() {
  Spec support("support", "Nodes that are held in some directions.");
  support.words("on", "Names of edges (for instance front.top) or of whole panels (front).")
      .choice("hold", "Directions that are held; none: only \"director\".",
              {"x", "y", "z", "xy", "xz", "yz", "xyz", "none"})
      .reals("move by", "mm", "Displacement of the held directions at load 1 (x, y, z).", base::Reals{0.0, 0.0, 0.0})
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
      .reals("axis point", "mm", "Point of the axis of \"turn by\".", base::Reals{0.0, 0.0, 0.0})
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
  for (int i = 0; i < 3; ++i) {
    const bool along_axis = std::abs(support.turn->axis[i]) >= along;
    is_held = is_held && (support.held[i] || along_axis);
    if (along_axis) allowed += " or \"" + std::string("xyz").erase(static_cast<size_t>(i), 1) + "\"";
  }
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

}  // namespace

std::vector<Support> read_supports(const List& list, const mesh::Mesh& mesh) {
  std::vector<Support> supports;
  for (const List& entry : list.entries()) {
    Support s;
    s.name = entry.name();
    if (entry.words("on").empty()) entry.fail("on", "names no edge and no panel");
    for (const std::string& set : entry.words("on")) {
      const std::vector<int> nodes = read_nodes(entry, mesh, set);
      s.nodes.insert(s.nodes.end(), nodes.begin(), nodes.end());
    }
    const std::string& hold = entry.word("hold");
    for (int i = 0; i < 3; ++i) s.held[i] = hold != "none" && hold.find("xyz"[i]) != std::string::npos;
    s.displacement = read_vector(entry, "move by");
    for (int i = 0; i < 3; ++i)
      if (s.displacement[i] != 0.0 && !s.held[i])
        entry.fail("move by", std::string("moves in ") + "xyz"[i] + ", but \"hold\" is \"" + hold + "\"");
    s.path = read_path(entry);
    const std::string& director = entry.word("director");
    s.director = director == "held"        ? DirectorSupport::held
                 : director == "symmetry"  ? DirectorSupport::symmetry
                 : director == "diaphragm" ? DirectorSupport::diaphragm
                                           : DirectorSupport::free;
    if (s.director == DirectorSupport::diaphragm && hold.size() != 2)
      entry.fail(
          "director",
          "\"diaphragm\" needs the two held directions of its plane (xy, xz or yz), but \"hold\" is \"" + hold + "\"");
    if (hold == "none" && s.director != DirectorSupport::held)
      entry.fail("hold", "holds nothing: name a direction, or hold the director of a shell (\"director\" = held)");
    read_turn(entry, s);
    supports.push_back(s);
  }
  return supports;
}

}  // namespace toile::solve
