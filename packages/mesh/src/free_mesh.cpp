#include "toile/mesh/free_mesh.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>

#include "toile/base/error.hpp"
#include "toile/base/process.hpp"

namespace toile::mesh {
namespace {

namespace fs = std::filesystem;

/// The program lies beside the one that runs, or where the build left it.
std::string mesher() {
  std::error_code ignored;
  const fs::path beside = fs::read_symlink("/proc/self/exe", ignored).parent_path() / "toile-mesher";
  return fs::exists(beside, ignored) ? beside.string() : TOILE_MESHER;
}

// Numbers are rounded to 1e-9 mm: a mesh may be another one where its input differs by round-off, and this way it is
// the same on every processor.
std::string request(const FreeMeshInput& input, const char* kind) {
  std::ostringstream out;
  out << std::fixed;
  out.precision(9);
  const auto points = [&out](const std::vector<Vec2>& all) {
    out << all.size() << '\n';
    for (const Vec2& p : all) out << p.x() << ' ' << p.y() << '\n';
  };
  const auto lines = [&out](const std::vector<std::vector<int>>& all) {
    out << all.size() << '\n';
    for (const std::vector<int>& line : all) {
      out << line.size();
      for (const int p : line) out << ' ' << p;
      out << '\n';
    }
  };
  out << kind << ' ' << input.size << '\n';
  points(input.points);
  lines(input.loops);
  lines(input.lines);
  out << input.refinements.size() << '\n';
  for (const Refinement& r : input.refinements) {
    out << r.size << ' ' << r.distance << ' ';
    points(r.points);
  }
  return out.str();
}

/// A stream refuses numbers below the smallest normal one, which a node near an axis may have.
double read_number(std::istream& in) {
  std::string word;
  in >> word;
  return std::strtod(word.c_str(), nullptr);
}

template <std::size_t N>
std::vector<std::array<int, N>> read_elements(std::istream& in, int nodes) {
  std::size_t count = 0;
  in >> count;
  std::vector<std::array<int, N>> all;
  for (std::array<int, N> element{}; in && all.size() < count; all.push_back(element))
    for (int& node : element)
      if (!(in >> node) || node < 0 || node >= nodes) throw base::InputError("the mesher's answer ends too early");
  return all;
}

FreeMesh read_mesh(const std::string& text) {
  std::istringstream in(text);
  std::size_t count = 0;
  in >> count;
  FreeMesh mesh;
  while (in && mesh.nodes.size() < count) {
    const double x = read_number(in);
    mesh.nodes.emplace_back(x, read_number(in));
  }
  const int nodes = static_cast<int>(mesh.nodes.size());
  mesh.quadrilaterals = read_elements<4>(in, nodes);
  mesh.triangles = read_elements<3>(in, nodes);
  if (!in) throw base::InputError("the mesher's answer ends too early");
  return mesh;
}

std::string why_failed(const base::ProcessEnd& end, double most_seconds) {
  std::ostringstream text;
  if (!end.found)
    text << "the mesher \"" << mesher() << "\" was not found; it is built and installed with Toile";
  else if (end.out_of_time)
    text << "the mesher did not end within " << most_seconds << " s; a larger element size may help";
  else if (end.signal != 0)
    text << "the mesher crashed (signal " << end.signal << "); another element size may help";
  else
    text << "the mesher failed: " << (end.errors.empty() ? "it does not say why" : end.errors);
  return text.str();
}

FreeMesh run_mesher(const FreeMeshInput& input, double most_seconds) {
  base::ProcessOptions options;
  options.most_seconds = most_seconds;
  const auto run = [&](const char* kind) {
    options.input = request(input, kind);
    return base::run_process({mesher()}, options);
  };
  base::ProcessEnd end = run(input.triangles ? "triangles" : "quadrilaterals");
  // Gmsh aborts where lines leave a part of triangles that cannot all be paired: one amid three in a corner, say.
  if (end.signal != 0 && !end.out_of_time && !input.triangles) end = run("greedy-quadrilaterals");
  if (!end.found || end.out_of_time || end.status != 0) throw base::InputError(why_failed(end, most_seconds));
  FreeMesh mesh = read_mesh(end.output);
  constexpr double rounded = 1e-8;  // mm
  for (std::size_t k = 0; k < input.points.size(); ++k) {
    if (k >= mesh.nodes.size() || (mesh.nodes[k] - input.points[k]).norm() > rounded)
      throw base::InputError("the mesher moved or lost a node of the outline");
    mesh.nodes[k] = input.points[k];
  }
  return mesh;
}

/// Calls work(element) for each element of either kind.
template <class F>
void for_each_element(const FreeMesh& mesh, const F& work) {
  for (const auto& element : mesh.quadrilaterals) work(element);
  for (const auto& element : mesh.triangles) work(element);
}

/// Moves each inner node towards the mean of its neighbours; nodes of the input stay.
void smooth(FreeMesh& mesh, const FreeMeshInput& input) {
  constexpr int sweeps = 4;
  std::vector<std::vector<int>> neighbours(mesh.nodes.size());
  for_each_element(mesh, [&](const auto& element) {
    for (std::size_t k = 0; k < element.size(); ++k)
      neighbours[static_cast<std::size_t>(element[k])].push_back(element[(k + 1) % element.size()]);
  });
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (std::size_t n = input.points.size(); n < mesh.nodes.size(); ++n) {
      Vec2 mean = Vec2::Zero();
      for (const int other : neighbours[n]) mean += mesh.nodes[static_cast<std::size_t>(other)];
      mesh.nodes[n] = mean / static_cast<double>(neighbours[n].size());
    }
}

/// An area of twice the size, whose loops and lines go through every second point.
class Coarse {
 public:
  explicit Coarse(const FreeMeshInput& input) : fine_(input), coarse_(input), number_(input.points.size(), -1) {
    coarse_.points.clear();
    coarse_.size *= 2.0;
    for (Refinement& r : coarse_.refinements) r.size *= 2.0;
    for (std::vector<int>& loop : coarse_.loops) thin_out(loop, true);
    for (std::vector<int>& line : coarse_.lines) thin_out(line, false);
  }
  const FreeMeshInput& input() const { return coarse_; }

  /// Divides the elements of the coarse mesh.
  FreeMesh divided(const FreeMesh& mesh) {
    FreeMesh fine;
    fine.nodes = fine_.points;
    node_.assign(mesh.nodes.size(), -1);
    for (std::size_t k = 0; k < original_.size(); ++k) node_[k] = original_[k];
    for (std::size_t k = original_.size(); k < mesh.nodes.size(); ++k) node_[k] = add(fine, mesh.nodes[k]);
    for (const auto& element : mesh.quadrilaterals) divide(element, fine);
    for (const auto& element : mesh.triangles) divide(element, fine);
    return fine;
  }

 private:
  using Side = std::pair<int, int>;

  static Side side(int a, int b) { return {std::min(a, b), std::max(a, b)}; }
  static int add(FreeMesh& mesh, const Vec2& node) {
    mesh.nodes.push_back(node);
    return static_cast<int>(mesh.nodes.size()) - 1;
  }
  int coarse_number(int point) {
    int& number = number_[static_cast<std::size_t>(point)];
    if (number < 0) {
      number = static_cast<int>(coarse_.points.size());
      coarse_.points.push_back(fine_.points[static_cast<std::size_t>(point)]);
      original_.push_back(point);
    }
    return number;
  }
  void thin_out(std::vector<int>& line, bool closed) {
    const std::size_t sides = line.size() - (closed ? 0 : 1);
    if (sides % 2 != 0) throw base::InputError("a loop or line of an odd number of sides cannot bound quadrilaterals");
    std::vector<int> thin;
    for (std::size_t k = 0; k < line.size(); k += 2) thin.push_back(coarse_number(line[k]));
    for (std::size_t k = 0; k < sides; k += 2) middle_[side(line[k], line[(k + 2) % line.size()])] = line[k + 1];
    line = std::move(thin);
  }
  /// Node in the middle of a side: the point between, where the side is part of a loop or line.
  int middle(int a, int b, FreeMesh& fine) {
    const auto [at, is_new] = middle_.try_emplace(side(a, b), -1);
    if (is_new) {
      const int node =
          add(fine, 0.5 * (fine.nodes[static_cast<std::size_t>(a)] + fine.nodes[static_cast<std::size_t>(b)]));
      at->second = node;
    }
    return at->second;
  }
  template <std::size_t N>
  void divide(const std::array<int, N>& element, FreeMesh& fine) {
    std::array<int, N> corner{}, between{};
    Vec2 centre = Vec2::Zero();
    for (std::size_t k = 0; k < N; ++k) corner[k] = node_[static_cast<std::size_t>(element[k])];
    for (std::size_t k = 0; k < N; ++k) {
      between[k] = middle(corner[k], corner[(k + 1) % N], fine);
      centre += fine.nodes[static_cast<std::size_t>(between[k])] / static_cast<double>(N);
    }
    const int middle_node = add(fine, centre);
    for (std::size_t k = 0; k < N; ++k)
      fine.quadrilaterals.push_back({corner[k], between[k], middle_node, between[(k + N - 1) % N]});
  }

  const FreeMeshInput& fine_;
  FreeMeshInput coarse_;
  std::vector<int> number_;    ///< [point] its number in the coarse area; -1: it lies between two
  std::vector<int> original_;  ///< [coarse point]
  std::vector<int> node_;      ///< [node of the coarse mesh] of the fine one
  std::map<Side, int> middle_;
};

}  // namespace

FreeMesh mesh_freely(const FreeMeshInput& input, double most_seconds) {
  FreeMesh mesh;
  if (input.triangles) {
    mesh = run_mesher(input, most_seconds);
  } else {
    Coarse coarse(input);
    mesh = coarse.divided(run_mesher(coarse.input(), most_seconds));
  }
  smooth(mesh, input);
  return mesh;
}

}  // namespace toile::mesh
