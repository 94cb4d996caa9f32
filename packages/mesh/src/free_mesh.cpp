#include "toile/mesh/free_mesh.hpp"

#include <cstdlib>
#include <filesystem>
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

std::string request(const FreeMeshInput& input) {
  std::ostringstream out;
  out.precision(17);
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
  out << (input.triangles ? "triangles " : "quadrilaterals ") << input.size << '\n';
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

}  // namespace

FreeMesh mesh_freely(const FreeMeshInput& input, double most_seconds) {
  base::ProcessOptions options;
  options.input = request(input);
  options.most_seconds = most_seconds;
  const base::ProcessEnd end = base::run_process({mesher()}, options);
  if (!end.found || end.out_of_time || end.status != 0) throw base::InputError(why_failed(end, most_seconds));
  FreeMesh mesh = read_mesh(end.output);
  for (std::size_t k = 0; k < input.points.size(); ++k)
    if (k >= mesh.nodes.size() || mesh.nodes[k] != input.points[k])
      throw base::InputError("the mesher moved or lost a node of the outline");
  return mesh;
}

}  // namespace toile::mesh
