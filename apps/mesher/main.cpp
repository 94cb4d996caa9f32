// toile-mesher: reads an area from standard input and writes its mesh to standard output (see mesh/free_mesh.hpp). It
// is a program of its own, so that whatever happens inside of Gmsh ends this program and not the one that asked.
#include <gmsh.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Lines = std::vector<std::vector<int>>;

struct Points {
  std::vector<double> x, y;
};

struct Refinement {
  double size = 0.0, distance = 0.0;
  Points points;
};

struct Area {
  bool triangles = false, greedy = false;
  double size = 0.0;
  Points points;
  Lines loops, lines;
  std::vector<Refinement> refinements;
};

/// A stream refuses numbers below the smallest normal one, which a point near an axis may have.
double read_number(std::istream& in) {
  std::string word;
  in >> word;
  return std::strtod(word.c_str(), nullptr);
}

Points read_points(std::istream& in) {
  std::size_t count = 0;
  in >> count;
  Points points;
  while (in && points.x.size() < count) {
    points.x.push_back(read_number(in));
    points.y.push_back(read_number(in));
  }
  return points;
}

Lines read_lines(std::istream& in, int points) {
  std::size_t count = 0;
  in >> count;
  Lines lines;
  while (in && lines.size() < count) {
    std::size_t length = 0;
    in >> length;
    std::vector<int> line;
    for (int p = 0; line.size() < length && in >> p;) line.push_back(p);
    if (std::any_of(line.begin(), line.end(), [points](int p) { return p < 0 || p >= points; }))
      in.setstate(std::ios::failbit);
    lines.push_back(std::move(line));
  }
  return lines;
}

Area read_area(std::istream& in) {
  Area area;
  std::string kind;
  in >> kind >> area.size;
  area.triangles = kind == "triangles";
  area.greedy = kind == "greedy-quadrilaterals";
  area.points = read_points(in);
  area.loops = read_lines(in, static_cast<int>(area.points.x.size()));
  area.lines = read_lines(in, static_cast<int>(area.points.x.size()));
  std::size_t count = 0;
  in >> count;
  while (in && area.refinements.size() < count) {
    Refinement r;
    in >> r.size >> r.distance;
    r.points = read_points(in);
    area.refinements.push_back(std::move(r));
  }
  return area;
}

/// Lines between neighbouring points, which are not divided.
std::vector<int> add_lines(const std::vector<int>& points, bool closed) {
  std::vector<int> lines;
  for (std::size_t k = 0; k + (closed ? 0 : 1) < points.size(); ++k)
    lines.push_back(gmsh::model::geo::addLine(points[k] + 1, points[(k + 1) % points.size()] + 1));
  return lines;
}

/// [refinement] Its points as those of Gmsh.
std::vector<std::vector<double>> add_refinements(const Area& area) {
  std::vector<std::vector<double>> all;
  for (const Refinement& r : area.refinements) {
    all.emplace_back();
    for (std::size_t k = 0; k < r.points.x.size(); ++k)
      all.back().push_back(gmsh::model::geo::addPoint(r.points.x[k], r.points.y[k], 0.0));
  }
  return all;
}

/// Length of sides: the smallest that a refinement, the panel or the neighbouring points of the loops ask for.
void set_sizes(const Area& area, const std::vector<std::vector<double>>& centres) {
  namespace field = gmsh::model::mesh::field;
  std::vector<double> all;
  for (std::size_t k = 0; k < area.refinements.size(); ++k) {
    const Refinement& r = area.refinements[k];
    const int distance = field::add("Distance");
    field::setNumbers(distance, "PointsList", centres[k]);
    const int threshold = field::add("Threshold");
    field::setNumber(threshold, "InField", distance);
    field::setNumber(threshold, "SizeMin", r.size);
    field::setNumber(threshold, "SizeMax", area.size);
    field::setNumber(threshold, "DistMin", std::min(r.size, 0.5 * r.distance));  // an element of that size fits
    field::setNumber(threshold, "DistMax", r.distance);
    all.push_back(threshold);
  }
  if (!all.empty()) {
    const int least = field::add("Min");
    field::setNumbers(least, "FieldsList", all);
    field::setAsBackgroundMesh(least);
  }
  gmsh::option::setNumber("Mesh.MeshSizeMax", area.size);
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 1);
}

void generate(const Area& area) {
  namespace geo = gmsh::model::geo;
  gmsh::model::add("panel");
  for (std::size_t k = 0; k < area.points.x.size(); ++k)
    geo::addPoint(area.points.x[k], area.points.y[k], 0.0, 0.0, static_cast<int>(k) + 1);
  std::vector<int> loops, kept, inside;
  for (const std::vector<int>& loop : area.loops) {
    const std::vector<int> lines = add_lines(loop, true);
    kept.insert(kept.end(), lines.begin(), lines.end());
    loops.push_back(geo::addCurveLoop(lines));
  }
  for (const std::vector<int>& line : area.lines) {
    const std::vector<int> lines = add_lines(line, false);
    inside.insert(inside.end(), lines.begin(), lines.end());
  }
  kept.insert(kept.end(), inside.begin(), inside.end());
  const int surface = geo::addPlaneSurface(loops);
  const std::vector<std::vector<double>> centres = add_refinements(area);
  // Once only: it forgets what the mesh of lines and areas is to be.
  geo::synchronize();
  if (!inside.empty()) gmsh::model::mesh::embed(1, inside, 2, surface);
  for (const int line : kept) gmsh::model::mesh::setTransfiniteCurve(line, 2);
  set_sizes(area, centres);
  gmsh::option::setNumber("Mesh.Algorithm", 6);                                 // frontal Delaunay
  gmsh::option::setNumber("Mesh.RecombinationAlgorithm", area.greedy ? 0 : 1);  // 1: Blossom
  gmsh::option::setNumber("General.NumThreads", 1);
  if (!area.triangles) gmsh::model::mesh::setRecombine(2, surface);
  gmsh::model::mesh::generate(2);
}

/// Numbers the nodes: first the points of the area in their order, then the others in Gmsh's.
std::map<std::size_t, int> number_nodes(const Area& area, std::vector<double>& x, std::vector<double>& y) {
  x = area.points.x;
  y = area.points.y;
  std::map<std::size_t, int> number;
  std::vector<std::size_t> tags;
  std::vector<double> at, unused;
  for (std::size_t k = 0; k < area.points.x.size(); ++k) {
    gmsh::model::mesh::getNodes(tags, at, unused, 0, static_cast<int>(k) + 1);
    for (const std::size_t tag : tags) number[tag] = static_cast<int>(k);
  }
  gmsh::model::mesh::getNodes(tags, at, unused, 2, -1);
  for (std::size_t k = 0; k < tags.size(); ++k) {
    number[tags[k]] = static_cast<int>(x.size());
    x.push_back(at[3 * k]);
    y.push_back(at[3 * k + 1]);
  }
  return number;
}

/// Elements of one kind, counter-clockwise; Gmsh's surface may look to either side.
void write_elements(std::ostream& out, int kind, int corners, const std::map<std::size_t, int>& number,
                    const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<std::size_t> tags, nodes;
  gmsh::model::mesh::getElementsByType(kind, tags, nodes);
  out << tags.size() << '\n';
  for (std::size_t e = 0; e < tags.size(); ++e) {
    std::vector<int> element;
    for (int k = 0; k < corners; ++k) element.push_back(number.at(nodes[e * corners + k]));
    double twice = 0.0;
    for (int k = 0; k < corners; ++k) {
      const int a = element[k], b = element[(k + 1) % corners];
      twice += x[a] * y[b] - x[b] * y[a];
    }
    if (twice < 0.0) std::reverse(element.begin(), element.end());
    for (const int node : element) out << node << ' ';
    out << '\n';
  }
}

void write_mesh(std::ostream& out, const Area& area) {
  constexpr int triangle = 2, quadrilateral = 3;
  std::vector<double> x, y;
  const std::map<std::size_t, int> number = number_nodes(area, x, y);
  out.precision(17);
  out << x.size() << '\n';
  for (std::size_t k = 0; k < x.size(); ++k) out << x[k] << ' ' << y[k] << '\n';
  write_elements(out, quadrilateral, 4, number, x, y);
  write_elements(out, triangle, 3, number, x, y);
}

/// Writes all of a text; false if the reader is gone.
bool write_all(int file, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = write(file, text.data() + done, text.size() - done);
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

}  // namespace

int main() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody waits for the mesh of a program that was ended
  // Libraries inside of Gmsh print warnings to standard output, which is for the mesh alone.
  const int answer = dup(STDOUT_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  const Area area = read_area(std::cin);
  if (!std::cin || answer < 0) {
    std::cerr << "the description of the area is not complete";
    return 1;
  }
  try {
    gmsh::initialize();
    gmsh::option::setNumber("General.Terminal", 0);
    generate(area);
    std::ostringstream mesh;
    write_mesh(mesh, area);
    // What Gmsh holds ends with the process.
    std::_Exit(write_all(answer, mesh.str()) ? 0 : 1);
  } catch (const std::string& reason) {  // older versions of Gmsh throw texts
    std::cerr << reason;
  } catch (const std::exception& error) {
    std::cerr << error.what();
  }
  return 1;
}
