#include <cmath>
#include <sstream>

#include "toile/crossing/crossings.hpp"

namespace toile::crossing {

namespace {

/// What round-off leaves of a zero is none.
double to_hundredths(double mm) {
  return std::round(100.0 * mm) / 100.0 + 0.0;
}

}  // namespace

std::string text_of(const Crossings& crossings, const mesh::Mesh& mesh) {
  std::ostringstream text;
  text.precision(3);
  for (const PanelCrossing& c : crossings.panels) {
    const std::string &first = mesh.panels[static_cast<std::size_t>(c.first)].name,
                      &second = mesh.panels[static_cast<std::size_t>(c.second)].name;
    text << (&c == &crossings.panels.front() ? "" : ", ") << first << " x " << (c.first == c.second ? "itself" : second)
         << " (" << c.pairs << (c.pairs == 1 ? " pair" : " pairs") << " of elements, " << c.length << " mm long, "
         << c.depth << " mm deep near (" << to_hundredths(c.place[0]) << ", " << to_hundredths(c.place[1]) << ", "
         << to_hundredths(c.place[2]) << ") mm)";
  }
  return text.str();
}

}  // namespace toile::crossing
