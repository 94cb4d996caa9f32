#include <cmath>

#include "figure/scan.hpp"
#include "toile/base/error.hpp"

namespace toile::body {
namespace {

/// One leg from the crotch down.
struct Leg {
  const Finder& finder;
  int side;
  double crotch;
  Course course = {};  ///< height, girth

  std::string name(const std::string& part) const { return side_name(side) + part; }
  void add(const std::string& part, double z) const {
    const FigureLevel level = finder.scan.level(z);
    const SectionPiece* piece = finder.scan.beside(level, side);
    if (piece == nullptr) {
      finder.miss(name(part), "the leg has no closed section at its height");
    } else {
      finder.add(name(part), piece->centre, Vec3::UnitZ(), piece->tape_girth);
    }
  }
  void find();
};

/// The part of a course from `first` on.
Course tail(const Course& course, int first) {
  return {course.begin() + first, course.end()};
}

/// Middle of the places round number i that differ little from it: a smallest value may be flat.
double middle_of_flat(const Course& course, int i) {
  constexpr double same = 1.005;
  int first = i, last = i;
  while (first > 0 && course[first - 1].second < same * course[i].second) {
    --first;
  }
  while (last + 1 < static_cast<int>(course.size()) && course[last + 1].second < same * course[i].second) {
    ++last;
  }
  return 0.5 * (course[first].first + course[last].first);
}

void Leg::find() {
  constexpr double below_crotch = 0.02;  // of the height of the crotch above the floor: as near as a tape gets
  const FigureScan& scan = finder.scan;
  for (int i = scan.index(crotch); i >= 0; --i) {
    const SectionPiece* piece = scan.beside(scan.levels()[i], side);
    if (piece == nullptr) {
      break;
    }
    course.emplace_back(scan.levels()[i].z, piece->tape_girth);
  }
  add("thigh", crotch - below_crotch * (crotch - scan.bottom()));
  const int knee = first_narrow(course);
  const std::string no_knee = "the girth of the leg has no smallest value between thigh and calf";
  if (knee < 0) {
    finder.miss(name("knee"), no_knee);
    finder.miss(name("calf"), no_knee);
    finder.miss(name("ankle"), no_knee);
    return;
  }
  add("knee", middle_of_flat(course, knee));
  const Course shin = tail(course, knee);
  const int calf = first_wide(shin);
  if (calf < 0) {
    finder.miss(name("calf"), "the leg ends before its girth falls below the knee");
    finder.miss(name("ankle"), "the calf was not found");
    return;
  }
  add("calf", shin[calf].first);
  const Course lower = tail(shin, calf);
  int ankle = first_narrow(lower);
  if (ankle < 0) {
    ankle = steadiest(tail(lower, static_cast<int>(lower.size()) / 2));
    ankle += ankle < 0 ? 0 : static_cast<int>(lower.size()) / 2;
  }
  if (ankle < 0) {
    finder.miss(name("ankle"), "the girth of the leg has no smallest value below the calf");
  } else {
    add("ankle", lower[ankle].first);
  }
}

/// The feet say where the front is; false: there are none.
bool check_front(const Finder& finder) {
  const FigureScan& scan = finder.scan;
  bool feet = false;
  for (const int side : {1, -1}) {
    const Landmark* ankle = finder.find(std::string(side_name(side)) + "ankle");
    const FigureLevel sole = scan.level(scan.bottom() + 0.008 * scan.height());
    const SectionPiece* foot = scan.beside(sole, side);
    if (ankle == nullptr || foot == nullptr || foot->tape_girth < 1.2 * ankle->girth) {
      continue;
    }
    feet = true;
    const Vec3 toes = foot->centre - ankle->point;
    if (-toes.y() < std::abs(toes.x())) {
      const std::string found = std::abs(toes.x()) > std::abs(toes.y()) ? (toes.x() > 0.0 ? "+x" : "-x") : "+y";
      throw base::InputError("the feet of the body point towards " + found +
                             "; landmarks are found on a body that looks towards -y, with z up: turn it about z");
    }
  }
  return feet;
}

}  // namespace

bool find_legs(const Finder& finder) {
  const Landmark* crotch = finder.find("crotch");
  if (crotch == nullptr) {
    for (const int side : {1, -1}) {
      for (const char* part : {"thigh", "knee", "calf", "ankle"}) {
        finder.miss(side_name(side) + std::string(part), "the crotch, from which a leg goes down, was not found");
      }
    }
    return false;
  }
  for (const int side : {1, -1}) {
    Leg{finder, side, crotch->point.z()}.find();
  }
  return check_front(finder);
}

}  // namespace toile::body
