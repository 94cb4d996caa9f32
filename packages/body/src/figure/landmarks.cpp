#include "toile/body/landmarks.hpp"

#include <algorithm>
#include <cmath>

#include "figure/scan.hpp"
#include "figure/stance.hpp"
#include "toile/base/error.hpp"

namespace toile::body {
namespace {

constexpr const char* round_trunk =
    "the trunk of the body is as deep as it is wide, so which way it looks cannot be told from it: it is taken to look "
    "towards -y, with its left at greater x. Is it turned about z, then landmarks in front, behind and at the sides "
    "are "
    "not where they are named";

constexpr const char* no_front =
    "nothing of the chest stands out to the front, and the body has no feet that say where that is: does it look "
    "towards +y? Landmarks are found on a body that looks towards -y; else left and right are exchanged, and those in "
    "front and behind are not where they are named";

const base::Texts paired = {"shoulder", "shoulder blade", "armpit", "upper arm", "elbow",
                            "wrist",    "thigh",          "knee",   "calf",      "ankle"};

/// Half way between left and right: the height of both.
void add_middles(const Finder& finder) {
  for (const std::string& part : paired) {
    const Landmark *left = finder.find("left " + part), *right = finder.find("right " + part);
    if (left != nullptr && right != nullptr) {
      finder.add(part, 0.5 * (left->point + right->point));
    } else {
      finder.miss(part, std::string("it is half way between left and right, and the ") +
                            (left == nullptr ? "left" : "right") + " one was not found");
    }
  }
}

/// On a body that looks straight ahead.
Landmarks search(const TriangleMesh& mesh, const FigureScan& scan) {
  Landmarks all;
  all.found.reserve(landmark_names().size());  // the search holds on to what it found
  const Finder finder{scan, &all};
  find_crotch_and_armpits(finder);
  if (all.found.empty()) check_upright(mesh, scan);
  find_neck(finder);
  const bool feet = find_legs(finder);
  find_trunk(finder);
  const bool chest = all.find("left bust point") != nullptr || all.find("right bust point") != nullptr;
  if (!feet && !chest && all.find("waist") != nullptr) all.warnings.emplace_back(no_front);
  find_arms(finder);
  add_middles(finder);
  const auto place = [](const std::string& name) {
    const base::Texts& names = landmark_names();
    return std::find(names.begin(), names.end(), name) - names.begin();
  };
  std::sort(all.found.begin(), all.found.end(),
            [&place](const Landmark& a, const Landmark& b) { return place(a.name) < place(b.name); });
  std::sort(all.missing.begin(), all.missing.end(),
            [&place](const MissingLandmark& a, const MissingLandmark& b) { return place(a.name) < place(b.name); });
  return all;
}

}  // namespace

Landmarks find_landmarks(const TriangleMesh& mesh) {
  constexpr double straight = 1e-3;  // radians: less moves no landmark by 1 mm
  const FigureScan as_given(mesh);
  const std::optional<double> heading_found = heading(as_given);
  const double angle = heading_found.value_or(0.0);
  if (std::abs(angle) < straight) {
    Landmarks all = search(mesh, as_given);
    if (!heading_found) all.warnings.emplace_back(round_trunk);
    return all;
  }
  const TriangleMesh straightened = turned_about_z(mesh, -angle);
  Landmarks all = search(straightened, FigureScan(straightened));
  for (Landmark& landmark : all.found) {
    landmark.point = turned_about_z(landmark.point, angle);
    landmark.normal = turned_about_z(landmark.normal, angle);
  }
  return all;
}

Landmarks find_landmarks(const TriangleMesh& mesh, const std::string& file) {
  try {
    return find_landmarks(mesh);
  } catch (const base::InputError& error) {
    throw base::InputError(file + ": " + error.what());
  }
}

}  // namespace toile::body
