#include "figure/scan.hpp"

#include <algorithm>
#include <cmath>

#include "toile/base/error.hpp"

namespace toile::body {
namespace {

constexpr int scan_levels = 400;
// Shares of the square of the height.
constexpr double least_trunk_area = 1e-3, least_limb_area = 1.2e-4;
constexpr double change = 1.015;  // of a girth that counts as one

double middle_of(const Sections& sections, const Extent& extent) {
  std::vector<double> centres;
  for (double part = 0.40; part < 0.8; part += 0.02) {
    const double z = extent.lower.z() + part * (extent.upper.z() - extent.lower.z());
    const auto pieces = sections.cut({0.0, 0.0, z}, Vec3::UnitZ());
    const auto largest =
        std::max_element(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) { return a.area < b.area; });
    if (largest != pieces.end()) {
      centres.push_back(largest->centre.x());
    }
  }
  if (centres.empty()) {
    throw base::InputError("no horizontal section of the body is closed, so there are no landmarks");
  }
  std::nth_element(centres.begin(), centres.begin() + centres.size() / 2, centres.end());
  return centres[centres.size() / 2];
}

}  // namespace

FigureScan::FigureScan(const TriangleMesh& mesh) : sections_(mesh), extent_(extent_of(mesh)) {
  middle_ = middle_of(sections_, extent_);
  step_ = height() / scan_levels;
  for (int i = 0; i < scan_levels; ++i) {
    levels_.push_back(level(bottom() + (i + 0.5) * step_));
  }
}

FigureLevel FigureScan::level(double z) const {
  FigureLevel level;
  level.z = z;
  for (SectionPiece& piece : sections_.cut({0.0, 0.0, z}, Vec3::UnitZ())) {
    if (piece.closed) {
      level.pieces.push_back(std::move(piece));
    }
  }
  double largest = least_trunk_area * height() * height();
  for (std::size_t i = 0; i < level.pieces.size(); ++i) {
    const SectionPiece& piece = level.pieces[i];
    if (piece.area > largest && piece.lower.x() < middle_ && piece.upper.x() > middle_) {
      largest = piece.area;
      level.trunk = static_cast<int>(i);
    }
  }
  return level;
}

int FigureScan::index(double z) const {
  const int i = static_cast<int>(std::floor((z - bottom()) / step_ - 0.5));
  return std::clamp(i, 0, scan_levels - 1);
}

const SectionPiece* FigureScan::beside(const FigureLevel& level, int side) const {
  const SectionPiece* nearest = nullptr;
  for (std::size_t i = 0; i < level.pieces.size(); ++i) {
    const SectionPiece& piece = level.pieces[i];
    const double away = side * (piece.centre.x() - middle_);
    if (static_cast<int>(i) == level.trunk || away <= 0.0 || piece.area < least_limb_area * height() * height()) {
      continue;
    }
    if (nearest == nullptr || away < side * (nearest->centre.x() - middle_)) {
      nearest = &piece;
    }
  }
  return nearest;
}

void Finder::add(const std::string& name, const Vec3& point, const Vec3& normal, double girth) const {
  marks->found.push_back({name, point, normal, girth});
}

void Finder::add_trunk_level(const std::string& name, double z) const {
  const FigureLevel level = scan.level(z);
  if (level.trunk_piece() == nullptr) {
    miss(name, "there is no section round the middle of the trunk at its height");
    return;
  }
  add(name, level.trunk_piece()->centre, Vec3::UnitZ(), level.trunk_piece()->tape_girth);
}

int first_narrow(const Course& course) {
  int least = 0;
  for (int i = 1; i < static_cast<int>(course.size()); ++i) {
    const bool grows_from_its_start = least == 0 && course[i].second > course[0].second;  // what counts comes later
    if (course[i].second < course[least].second || grows_from_its_start) {
      least = i;
    } else if (course[i].second > change * course[least].second && least > 0) {
      return least;
    }
  }
  return -1;
}

int first_wide(const Course& course) {
  int most = 0;
  for (int i = 1; i < static_cast<int>(course.size()); ++i) {
    if (course[i].second > course[most].second) {
      most = i;
    } else if (change * course[i].second < course[most].second) {
      return most;
    }
  }
  return -1;
}

Course relative_changes(const Course& course) {
  constexpr int around = 2;
  Course changes;
  for (int i = around; i + around < static_cast<int>(course.size()); ++i) {
    const double difference = std::abs(course[i + around].second - course[i - around].second);
    changes.emplace_back(course[i].first, difference / course[i].second);
  }
  return changes;
}

int steadiest(const Course& course) {
  const Course changes = relative_changes(course);
  const auto least = std::min_element(changes.begin(), changes.end(),
                                      [](const auto& a, const auto& b) { return a.second < b.second; });
  return least == changes.end() ? -1 : static_cast<int>(least - changes.begin()) + 2;
}

std::pair<Vec3, Vec3> nearest_pair(const SectionPiece& first, const SectionPiece& second) {
  std::pair<Vec3, Vec3> best{first.points.front(), second.points.front()};
  for (const Vec3& a : first.points) {
    for (const Vec3& b : second.points) {
      if ((a - b).squaredNorm() < (best.first - best.second).squaredNorm()) {
        best = {a, b};
      }
    }
  }
  return best;
}

}  // namespace toile::body
