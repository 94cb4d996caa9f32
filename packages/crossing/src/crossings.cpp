#include "toile/crossing/crossings.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "depth.hpp"
#include "fabric.hpp"
#include "meetings.hpp"

namespace toile::crossing {

namespace {

double length_of(const Segment& s) {
  return (s[1] - s[0]).norm();
}

Vec3 middle_of(const Segment& s) {
  return 0.5 * (s[0] + s[1]);
}

/// Each line once: elements on either side of a mesh line that lies on the crossing have the same.
double total_length(std::vector<Segment> segments) {
  constexpr double same = 1e-6;  // mm
  std::sort(segments.begin(), segments.end(),
            [](const Segment& a, const Segment& b) { return middle_of(a).x() < middle_of(b).x(); });
  double sum = 0.0;
  for (auto s = segments.begin(); s != segments.end(); ++s) {
    bool repeated = false;
    for (auto t = s; !repeated && t != segments.begin();) {
      --t;
      if (middle_of(*s).x() - middle_of(*t).x() > same) break;
      repeated = (middle_of(*s) - middle_of(*t)).norm() <= same && std::abs(length_of(*s) - length_of(*t)) <= same;
    }
    if (!repeated) sum += length_of(*s);
  }
  return sum;
}

/// What crosses of two panels.
struct Group {
  PanelCrossing crossing;
  std::vector<const Meeting*> meetings;
  double size = 0.0;  ///< mean of its elements, mm

  void add(const Meeting& meeting, double depth, double pair_size) {
    meetings.push_back(&meeting);
    size += (pair_size - size) / static_cast<double>(meetings.size());
    ++crossing.pairs;
    if (depth <= crossing.depth) return;
    crossing.depth = depth;
    crossing.place = middle_of(meeting.segments.front());
  }
  std::vector<Segment> segments() const {
    std::vector<Segment> all;
    for (const Meeting* meeting : meetings) all.insert(all.end(), meeting->segments.begin(), meeting->segments.end());
    return all;
  }
};

}  // namespace

bool available() {
  return true;
}

Crossings find_crossings(const mesh::Mesh& mesh, const std::vector<std::vector<int>>& clusters,
                         const std::vector<mesh::Vec3>& position) {
  const Fabric fabric(mesh, clusters, position);
  const std::vector<Meeting> meetings = find_meetings(fabric);
  Depth depth(fabric, meetings);
  std::map<std::pair<int, int>, Group> groups;
  for (const Meeting& meeting : meetings) {
    const double size = 0.5 * (fabric.size(meeting.first) + fabric.size(meeting.second));
    const double deep = depth.of(meeting);
    if (deep < least_depth * size) continue;
    const std::pair<int, int> panels = std::minmax(fabric.panel(meeting.first), fabric.panel(meeting.second));
    groups[panels].add(meeting, deep, size);
  }
  Crossings found;
  std::map<int, std::vector<Segment>> of_element;
  for (auto& [panels, group] : groups) {
    group.crossing.first = panels.first;
    group.crossing.second = panels.second;
    group.crossing.length = total_length(group.segments());
    if (group.crossing.length < least_length * group.size) continue;
    found.panels.push_back(group.crossing);
    for (const Meeting* meeting : group.meetings)
      for (const int e : {meeting->first, meeting->second})
        of_element[e].insert(of_element[e].end(), meeting->segments.begin(), meeting->segments.end());
  }
  found.length.assign(static_cast<std::size_t>(fabric.elements()), 0.0);
  for (const auto& [element, segments] : of_element) found.length[element] = total_length(segments);
  return found;
}

}  // namespace toile::crossing
