// Bodies that a test makes, written as files, and a sleeve that a scene wraps round them.
#pragma once

#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "app/program.hpp"

namespace toile::test {

using Point = std::array<double, 3>;

/// Facets of any number of corners over points, corners from 0.
struct Facets {
  std::vector<Point> points;
  std::vector<std::vector<int>> facets;
};

/// Tube about z from -100 mm on, closed by two fans of triangles, `rows` of quads of the given height, looking
/// outwards. Its radius at the sleeve's level, z = 82, is given.
inline Facets tube(double radius, int rows, double row_height, int around = 36, double slope = 0.0) {
  Facets tube;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i < around; ++i) {
      const double angle = 2.0 * M_PI * i / around;
      const double z = -100.0 + row_height * j, at = radius + slope * (z - 82.0);
      tube.points.push_back({at * std::cos(angle), at * std::sin(angle), z});
    }
  const int bottom = static_cast<int>(tube.points.size()), top = bottom + 1, last = rows * around;
  tube.points.push_back({0.0, 0.0, -100.0});
  tube.points.push_back({0.0, 0.0, -100.0 + row_height * rows});
  for (int i = 0; i < around; ++i) {
    const int next = (i + 1) % around;
    for (int j = 0; j < rows; ++j) {
      const int a = j * around;
      tube.facets.push_back({a + i, a + next, a + around + next, a + around + i});
    }
    tube.facets.push_back({bottom, next, i});
    tube.facets.push_back({top, last + i, last + next});
  }
  return tube;
}

/// How a dialect of OBJ writes things.
struct Dialect {
  std::string head, behind_vertex, between = " ", end = "\n";
  std::function<std::string(int corner, int points)> corner = [](int c, int) { return std::to_string(c + 1); };
};

inline std::string obj(const Facets& body, const Dialect& dialect = {}, double scale = 1.0) {
  std::ostringstream text;
  text.precision(9);
  text << dialect.head;
  for (const auto& [x, y, z] : body.points)
    text << "v " << scale * x << ' ' << scale * y << ' ' << scale * z << dialect.behind_vertex << dialect.end;
  for (const auto& facet : body.facets) {
    text << "f";
    for (const int c : facet) text << dialect.between << dialect.corner(c, static_cast<int>(body.points.size()));
    text << dialect.end;
  }
  return text.str();
}

/// Text STL of triangles; each copy of a vertex is moved by `shift()`.
inline std::string stl(const Facets& body, const std::function<double()>& shift) {
  std::ostringstream text;
  text.precision(12);
  text << "solid body\n";
  for (const auto& facet : body.facets)
    for (size_t k = 2; k < facet.size(); ++k) {
      text << "facet normal 0 0 0\nouter loop\n";
      for (const int c : {facet[0], facet[k - 1], facet[k]}) {
        text << "vertex";
        for (const double x : body.points[c]) text << ' ' << x + shift();
        text << '\n';
      }
      text << "endloop\nendfacet\n";
    }
  return text.str() + "endsolid body\n";
}

/// Pressure (kPa) of a sleeve of neo-Hookean fabric that is `width` mm wide and free along a cylinder of 60 mm.
inline double pressure_of(double width) {
  constexpr double c10 = 0.05, thickness = 0.5, radius = 60.0;  // MPa, mm
  const double stretch = 2.0 * M_PI * radius / width;
  return 1e3 * thickness / std::sqrt(stretch) * 2.0 * c10 * (stretch * stretch - 1.0 / stretch) / radius;
}

/// A sleeve on a body of the test, scene.xml with body.obj.
class Bodies : public ProgramTest {
 protected:
  /// Replaces texts of the scene, which must be there.
  void write_sleeve(const Edits& edits = {}) const {
    std::ifstream stream(TOILE_SOURCE_DIR "/test/data/cases/bodies/sleeve.xml");
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    for (const auto& [from, to] : edits) {
      ASSERT_NE(text.find(from), std::string::npos) << from;
      text.replace(text.find(from), from.size(), to);
    }
    write("scene.xml", text);
  }
  static std::pair<std::string, std::string> body(const std::string& parameters) {
    const std::string last = "value=\"body.obj\"/>";
    return {last, last + parameters};
  }
  /// Mean pressure at the level of results, kPa.
  double level_pressure() const {
    std::istringstream row(read("results/pressure-levels.csv"));
    std::string word;
    std::getline(row, word);
    for (int column = 0; column < 3; ++column) std::getline(row, word, ',');
    return word.empty() ? NAN : std::strtod(word.c_str(), nullptr);
  }
  /// Runs the scene and expects the pressure at its level, kPa; returns what the program printed.
  std::string expect_pressure(double expected, double tolerance) const {
    const Outcome outcome = toile("run scene.xml --output results");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NEAR(level_pressure() / expected, 1.0, tolerance);
    return outcome.out + outcome.err;
  }
  template <class Matcher>
  void expect_refused(const Matcher& message) const {
    for (const char* command : {"check", "run"}) {
      const Outcome outcome = toile(std::string(command) + " scene.xml");
      EXPECT_EQ(outcome.status, 2);
      EXPECT_THAT(outcome.err, ::testing::AllOf(::testing::StartsWith("toile: "), message));
    }
  }
};

inline std::string real(const std::string& name, double value) {
  return "<Parameter name=\"" + name + "\" type=\"double\" value=\"" + std::to_string(value) + "\"/>";
}
inline std::string flag(const std::string& name, bool value) {
  return "<Parameter name=\"" + name + "\" type=\"bool\" value=\"" + (value ? "true" : "false") + "\"/>";
}
inline std::string text(const std::string& name, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"string\" value=\"" + value + "\"/>";
}

// The mesh of 32 elements around gives 0.4 % less than the closed form.
constexpr double mesh_error = 0.006;

}  // namespace toile::test
