#pragma once

#include <string>
#include <utility>
#include <vector>

#include "toile/body/landmarks.hpp"
#include "toile/body/section.hpp"

namespace toile::body {

/// A horizontal section of a figure.
struct FigureLevel {
  double z = 0.0;
  std::vector<SectionPiece> pieces;  ///< closed ones
  int trunk = -1;                    ///< the one round the middle: trunk, neck or head; -1: none

  const SectionPiece* trunk_piece() const { return trunk < 0 ? nullptr : &pieces[trunk]; }
};

/// A standing body in horizontal sections, from its bottom up.
class FigureScan {
 public:
  explicit FigureScan(const TriangleMesh& mesh);

  const Sections& sections() const { return sections_; }
  const std::vector<FigureLevel>& levels() const { return levels_; }
  FigureLevel level(double z) const;
  /// Number of the highest level that is not above z.
  int index(double z) const;
  const Extent& extent() const { return extent_; }
  double bottom() const { return extent_.lower.z(); }
  double height() const { return extent_.upper.z() - extent_.lower.z(); }
  double step() const { return step_; }
  double middle() const { return middle_; }  ///< x between left and right
  /// Of the pieces on one side (+1 left, -1 right) of the middle and of the trunk, that nearest to the middle; null if
  /// there is none but those thinner than a finger.
  const SectionPiece* beside(const FigureLevel& level, int side) const;

 private:
  Sections sections_;
  Extent extent_;
  double step_ = 0.0;
  double middle_ = 0.0;
  std::vector<FigureLevel> levels_;
};

/// What the search knows so far.
struct Finder {
  const FigureScan& scan;
  Landmarks* marks;

  void add(const std::string& name, const Vec3& point, const Vec3& normal = Vec3::Zero(), double girth = 0.0) const;
  void miss(const std::string& name, const std::string& reason) const { marks->missing.push_back({name, reason}); }
  const Landmark* find(const std::string& name) const { return marks->find(name); }
  /// A level of the trunk.
  void add_trunk_level(const std::string& name, double z) const;
};

inline const char* side_name(int side) {
  return side > 0 ? "left " : "right ";
}

/// Girths along a limb, or something else along a line.
using Course = std::vector<std::pair<double, double>>;
/// Number of the smallest value behind which it grows by 1.5 %; -1: it never does.
int first_narrow(const Course& course);
/// Number of the greatest value behind which it falls by 1.5 %; -1: it never does.
int first_wide(const Course& course);
/// How much it changes round each place, two to either side, as a part of the value; without the two at each end.
Course relative_changes(const Course& course);
/// Number of the place with the least relative change, away from both ends; -1 of fewer than five places.
int steadiest(const Course& course);

/// Mean of the places of a course, with weights by the values there.
template <class Weight>
double mean_place(const Course& course, const Weight& weight) {
  double sum = 0.0, places = 0.0;
  for (const auto& [place, value] : course) {
    sum += weight(value);
    places += weight(value) * place;
  }
  return places / sum;
}

/// Nearest points of two curves.
std::pair<Vec3, Vec3> nearest_pair(const SectionPiece& first, const SectionPiece& second);

// Each finds a part of the landmarks and needs those before it.
void find_crotch_and_armpits(const Finder& finder);
void find_neck(const Finder& finder);
void find_trunk(const Finder& finder);
/// Whether there are feet, which say where the front is: they must point towards -y.
bool find_legs(const Finder& finder);
void find_arms(const Finder& finder);

}  // namespace toile::body
