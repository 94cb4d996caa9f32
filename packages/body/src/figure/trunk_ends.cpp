#include <algorithm>
#include <cmath>
#include <optional>

#include "figure/scan.hpp"

namespace toile::body {
namespace {

constexpr int bisections = 24;

void find_crotch(const Finder& finder) {
  const FigureScan& scan = finder.scan;
  const auto& levels = scan.levels();
  int i = scan.index(scan.bottom() + 0.72 * scan.height());
  while (i >= 0 && levels[i].trunk < 0) {
    --i;
  }
  while (i >= 0 && levels[i].trunk >= 0) {
    --i;
  }
  if (i < 0 || scan.beside(levels[i], 1) == nullptr || scan.beside(levels[i], -1) == nullptr) {
    finder.miss("crotch", "no height was found at which the trunk parts into two legs");
    return;
  }
  double legs = levels[i].z, trunk = levels[i + 1].z;
  for (int k = 0; k < bisections; ++k) {
    const double middle = 0.5 * (legs + trunk);
    (scan.level(middle).trunk >= 0 ? trunk : legs) = middle;
  }
  const FigureLevel below = scan.level(legs);
  const SectionPiece *left = scan.beside(below, 1), *right = scan.beside(below, -1);
  if (left == nullptr || right == nullptr) {
    finder.miss("crotch", "the trunk does not part into two legs");
    return;
  }
  const auto [a, b] = nearest_pair(*left, *right);
  // Its x is the middle between the thighs: right at the crotch there may be small pieces.
  constexpr double below_crotch = 0.01;  // of the height
  const FigureLevel thighs = scan.level(legs - below_crotch * scan.height());
  const SectionPiece *left_thigh = scan.beside(thighs, 1), *right_thigh = scan.beside(thighs, -1);
  const double x = left_thigh == nullptr || right_thigh == nullptr
                       ? scan.middle()
                       : 0.5 * (left_thigh->lower.x() + right_thigh->upper.x());
  finder.add("crotch", {x, 0.5 * (a.y() + b.y()), legs});
}

/// How far the trunk reaches to one side.
std::optional<double> reach(const FigureScan& scan, const FigureLevel& level, int side) {
  const SectionPiece* trunk = level.trunk_piece();
  if (trunk == nullptr) {
    return {};
  }
  return side > 0 ? trunk->upper.x() - scan.middle() : scan.middle() - trunk->lower.x();
}

/// Where the trunk's section jumps because the arm has joined it.
void find_armpit(const Finder& finder, int side) {
  constexpr double jump = 0.03;  // of the height
  const FigureScan& scan = finder.scan;
  const std::string name = std::string(side_name(side)) + "armpit";
  const Landmark* crotch = finder.find("crotch");
  const double from = crotch != nullptr ? crotch->point.z() + 0.1 * scan.height() : scan.bottom();
  for (int i = scan.index(from) + 1; i + 1 < static_cast<int>(scan.levels().size()); ++i) {
    const auto here = reach(scan, scan.levels()[i], side), next = reach(scan, scan.levels()[i + 1], side);
    if (!here || !next || *next - *here < jump * scan.height()) {
      continue;
    }
    double below = scan.levels()[i].z, above = scan.levels()[i + 1].z;
    for (int k = 0; k < bisections; ++k) {
      const double middle = 0.5 * (below + above);
      const auto there = reach(scan, scan.level(middle), side);
      (there && *there - *here > 0.5 * (*next - *here) ? above : below) = middle;
    }
    const FigureLevel level = scan.level(below);
    const SectionPiece *trunk = level.trunk_piece(), *arm = scan.beside(level, side);
    if (arm != nullptr) {
      const auto [a, b] = nearest_pair(*trunk, *arm);
      finder.add(name, 0.5 * (a + b));
    } else {
      const auto outermost =
          std::max_element(trunk->points.begin(), trunk->points.end(),
                           [side](const Vec3& a, const Vec3& b) { return side * a.x() < side * b.x(); });
      finder.add(name, *outermost);
    }
    return;
  }
  finder.miss(name, "no height was found at which an arm leaves the trunk");
}

}  // namespace

void find_crotch_and_armpits(const Finder& finder) {
  find_crotch(finder);
  find_armpit(finder, 1);
  find_armpit(finder, -1);
}

void find_neck(const Finder& finder) {
  const FigureScan& scan = finder.scan;
  const Landmark *left = finder.find("left armpit"), *right = finder.find("right armpit");
  if (left == nullptr && right == nullptr && finder.find("crotch") == nullptr) {
    // A ball has a greatest girth, too.
    const std::string reason = "neither crotch nor armpits were found, so nothing tells that this is a human body";
    finder.miss("crown", reason);
    finder.miss("neck", reason);
    return;
  }
  double from = scan.bottom() + 0.6 * scan.height();
  if (left != nullptr || right != nullptr) {
    from = std::max(left != nullptr ? left->point.z() : from, right != nullptr ? right->point.z() : from);
  }
  // A neck is less than half as wide as the trunk between the armpits.
  const double widest = left != nullptr && right != nullptr ? 0.5 * (left->point.x() - right->point.x()) : HUGE_VAL;
  Course course, stump;
  for (int i = scan.index(from) + 1; i < static_cast<int>(scan.levels().size()); ++i) {
    const SectionPiece* trunk = scan.levels()[i].trunk_piece();
    if (trunk == nullptr) {
      break;
    }
    course.emplace_back(scan.levels()[i].z, trunk->tape_girth);
    if (trunk->upper.x() - trunk->lower.x() < widest && trunk->tape_girth < 0.55 * course.front().second) {
      stump.push_back(course.back());
    }
  }
  const int narrow = first_narrow(course);
  if (narrow >= 0) {
    finder.add_trunk_level("neck", course[narrow].first);
    const double top = scan.extent().upper.z();
    const FigureLevel head = scan.level(top - 0.1 * scan.step());
    const Vec3 centre = head.pieces.empty() ? Vec3(scan.middle(), 0.0, top) : head.pieces.front().centre;
    finder.add("crown", {centre.x(), centre.y(), top});
    return;
  }
  finder.miss("crown", "the body has no head above a neck");
  // Of a body that ends there: above the shoulders.
  const Course changes = relative_changes(stump);
  if (changes.empty()) {
    finder.miss("neck", "no height above the shoulders has a smallest girth");
    return;
  }
  // Where the girth changes least; the mean of what changes nearly as little.
  double least = HUGE_VAL;
  for (const auto& place : changes) {
    least = std::min(least, place.second);
  }
  finder.add_trunk_level(
      "neck", mean_place(changes, [least](double change) { return std::pow((least + 1e-4) / (change + 1e-4), 4); }));
}

}  // namespace toile::body
