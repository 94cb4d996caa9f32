#include <charconv>
#include <cmath>
#include <sstream>

#include "toile/base/error.hpp"
#include "toile/base/parameters.hpp"
#include "toile/pattern/panel.hpp"

namespace toile::pattern {
namespace {

base::Texts edge_names(const Panel& panel) {
  base::Texts names;
  for (const Edge& edge : panel.outline) names.push_back(edge.name);
  for (const Loop& hole : panel.holes)
    for (const Edge& edge : hole) names.push_back(edge.name);
  return names;
}

/// Reads the bounds of one part of an edge.
class Bounds {
 public:
  Bounds(const Panel& panel, const Edge& edge, const std::string& name) : panel_(panel), edge_(edge), name_(name) {}

  EdgePart read(const std::string& inside) const {
    const std::size_t colon = inside.find(':');
    if (colon == std::string::npos || inside.find(':', colon + 1) != std::string::npos)
      fail("a part is written [from:to], e.g. [start:0.5]");
    const EdgePart part{&edge_, bound(inside.substr(0, colon)), bound(inside.substr(colon + 1))};
    if (part.from >= part.to) {
      std::ostringstream text;
      text << "it starts at " << part.from << " and ends at " << part.to
           << " of the edge's length; a part must end after its start";
      fail(text.str());
    }
    return part;
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw base::InputError("panel \"" + panel_.name + "\", part \"" + name_ + "\": " + problem);
  }

 private:
  double bound(const std::string& word) const {
    if (word == "start") return 0.0;
    if (word == "end") return 1.0;
    base::Texts names{"start", "end"};
    for (const Notch& notch : panel_.notches) {
      if (notch.edge != edge_.name) continue;
      if (notch.name == word) return notch.at;
      names.push_back(notch.name);
    }
    double value = 0.0;
    const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const std::string unit(rest, word.data() + word.size() - rest);
    if (error != std::errc() || !(unit.empty() || unit == "mm"))
      fail("the bound \"" + word +
           "\" is no notch of this edge, no relative length (0 to 1) and no length with its unit (30mm)" +
           base::hint(word, names));
    return relative(word, value, unit.empty());
  }

  double relative(const std::string& word, double value, bool is_relative) const {
    const double at = is_relative ? value : value / edge_.curve.length();
    if (at >= 0.0 && at <= 1.0) return at;
    std::ostringstream text;
    text << "the bound \"" << word << "\" lies outside of the edge; allowed are 0 to "
         << (is_relative ? 1.0 : edge_.curve.length()) << (is_relative ? " (relative length)" : " mm (its length)");
    fail(text.str());
  }

  const Panel& panel_;
  const Edge& edge_;
  const std::string& name_;
};

}  // namespace

EdgePart find_part(const Panel& panel, const std::string& name) {
  if (const Edge* whole = panel.edge(name)) return {whole, 0.0, 1.0};
  const std::size_t bracket = name.rfind('[');
  const std::string edge_name = name.substr(0, bracket);
  const Edge* edge = panel.edge(edge_name);
  if (edge == nullptr)
    throw base::InputError("panel \"" + panel.name + "\" has no edge \"" + edge_name + "\"" +
                           base::hint(edge_name, edge_names(panel)));
  const Bounds bounds(panel, *edge, name);
  if (name.back() != ']') bounds.fail("the \"]\" at its end is missing");
  return bounds.read(name.substr(bracket + 1, name.size() - bracket - 2));
}

Side find_side(const Pattern& pattern, const std::string& name) {
  const Panel* found = nullptr;
  base::Texts names;
  for (const Panel& panel : pattern.panels) {
    names.push_back(panel.name);
    const bool fits = name.compare(0, panel.name.size() + 1, panel.name + ".") == 0;
    if (fits && (found == nullptr || panel.name.size() > found->name.size())) found = &panel;
  }
  if (found != nullptr) return {found, find_part(*found, name.substr(found->name.size() + 1))};
  const std::string wanted = name.substr(0, name.find('.'));
  if (wanted.size() == name.size())
    throw base::InputError("\"" + name + "\" is no edge of a panel; write \"panel.edge\" or \"panel.edge[from:to]\"");
  throw base::InputError("there is no panel \"" + wanted + "\" for \"" + name + "\"" + base::hint(wanted, names));
}

}  // namespace toile::pattern
