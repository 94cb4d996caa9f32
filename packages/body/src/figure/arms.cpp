#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "figure/arm_line.hpp"
#include "figure/scan.hpp"

namespace toile::body {
namespace {

/// The closed piece of a section whose centre is nearest to a point; none if there is none.
const SectionPiece* nearest_piece(const std::vector<SectionPiece>& pieces, const Vec3& point) {
  const SectionPiece* nearest = nullptr;
  for (const SectionPiece& piece : pieces) {
    if (piece.closed && (nearest == nullptr || (piece.centre - point).norm() < (nearest->centre - point).norm())) {
      nearest = &piece;
    }
  }
  return nearest;
}

/// Direction of the arm below the armpit: along the centres of its horizontal sections; level if it has none.
Vec3 first_direction(const FigureScan& scan, const Vec3& armpit, int side, Vec3* start) {
  const double near = armpit.z() - 2.0 * scan.step(), far = armpit.z() - 0.05 * scan.height();
  const FigureLevel upper = scan.level(near), lower = scan.level(far);
  const SectionPiece *first = scan.beside(upper, side), *second = scan.beside(lower, side);
  if (first != nullptr && second != nullptr) {
    *start = first->centre;
    return (second->centre - first->centre).normalized();
  }
  const Vec3 outwards(side, 0.0, 0.0);
  *start = armpit;
  const auto pieces = scan.sections().cut(armpit + 0.03 * scan.height() * outwards, outwards);
  const SectionPiece* piece = nearest_piece(pieces, armpit);
  if (piece != nullptr) {
    *start = piece->centre;
  }
  return outwards;
}

}  // namespace

std::vector<ArmStation> arm_line(const FigureScan& scan, const Vec3& armpit, int side) {
  constexpr double part = 0.004, least_girth = 0.04, most_drop = 0.75, turning = 0.3;
  constexpr int most = 250, span = 4;
  const double step = part * scan.height();
  std::vector<ArmStation> line;
  Vec3 centre;
  Vec3 direction = first_direction(scan, armpit, side, &centre);
  for (int k = 0; k < most; ++k) {
    const auto pieces = scan.sections().cut(centre, direction);
    const SectionPiece* piece = nearest_piece(pieces, centre);
    const bool lost = piece == nullptr || piece->tape_girth < least_girth * scan.height() ||
                      (piece->centre - centre).norm() > 4.0 * step ||
                      (!line.empty() && piece->tape_girth < most_drop * line.back().girth);
    if (lost) {
      break;
    }
    const double along = line.empty() ? 0.0 : line.back().along + (piece->centre - line.back().centre).norm();
    line.push_back({piece->centre, direction, piece->tape_girth, along});
    if (static_cast<int>(line.size()) > span) {
      const Vec3 chord = (line.back().centre - line[line.size() - 1 - span].centre).normalized();
      direction = ((1.0 - turning) * direction + turning * chord).normalized();
    }
    centre = piece->centre + step * direction;
  }
  return line;
}

namespace {

/// The station at which two straight lines fit the centres best, and the angle between them.
int bend_of(const std::vector<ArmStation>& line, int wrist, double* angle) {
  const auto residual = [&line](int from, int to) {
    const Vec3 start = line[from].centre, along = (line[to].centre - start).normalized();
    double sum = 0.0;
    for (int i = from; i <= to; ++i) {
      const Vec3 away = line[i].centre - start;
      sum += (away - away.dot(along) * along).squaredNorm();
    }
    return sum;
  };
  int best = wrist / 2;
  double least = std::numeric_limits<double>::infinity();
  for (int i = wrist / 4; i <= 3 * wrist / 4; ++i) {
    const double sum = residual(0, i) + residual(i, wrist);
    if (sum < least) {
      least = sum;
      best = i;
    }
  }
  const Vec3 upper = (line[best].centre - line[0].centre).normalized();
  const Vec3 lower = (line[wrist].centre - line[best].centre).normalized();
  *angle = std::acos(std::clamp(upper.dot(lower), -1.0, 1.0));
  return best;
}

/// Number of the station of the wrist: the thinnest one before the hand; of an arm that is cut there, and has no place
/// behind which it gets wider, the steadiest. -1: none.
int wrist_of(const std::vector<ArmStation>& line) {
  constexpr double fallen = 0.99, grown = 1.005;
  const int from = static_cast<int>(0.4 * line.size()), last = static_cast<int>(line.size()) - 1;
  // From the end back to where the hand, or what is left of it, is widest.
  int wide = last;
  for (int i = last; i >= from && line[i].girth > fallen * line[wide].girth; --i) {
    if (line[i].girth > line[wide].girth) {
      wide = i;
    }
  }
  int narrow = wide;
  for (int i = wide; i >= from; --i) {
    if (line[i].girth < line[narrow].girth) {
      narrow = i;
    }
  }
  if (line[wide].girth > grown * line[narrow].girth) {
    return narrow;
  }
  const int half = (from + last) / 2;
  Course course;
  for (int i = half; i <= last; ++i) {
    course.emplace_back(line[i].along, line[i].girth);
  }
  const int steady = steadiest(course);
  return steady < 0 ? -1 : half + steady;
}

class Arm {
 public:
  Arm(const Finder& finder, int side, const Vec3& armpit) : finder_(finder), side_(side), armpit_(armpit) {}
  void find();

 private:
  std::string name(const std::string& part) const { return side_name(side_) + part; }
  void find_shoulder(const Vec3& direction);
  void add(const std::string& part, const ArmStation& station) {
    finder_.add(name(part), station.centre, station.direction, station.girth);
  }
  void miss_below_shoulder(const std::string& reason) {
    for (const char* part : {"upper arm", "elbow", "wrist"}) {
      finder_.miss(name(part), reason);
    }
  }

  const Finder& finder_;
  int side_;
  Vec3 armpit_;
  Vec3 shoulder_ = Vec3::Zero();
};

/// The highest point over the armpit, in the plane that parts the arm from the shoulder.
void Arm::find_shoulder(const Vec3& direction) {
  const Vec3 normal = armhole_normal(direction, side_);
  const Vec3 up = (Vec3::UnitZ() - normal.z() * normal).normalized();
  shoulder_ = armpit_;
  for (const SectionPiece& piece : finder_.scan.sections().cut(armpit_, normal)) {
    if (std::none_of(piece.points.begin(), piece.points.end(),
                     [this](const Vec3& p) { return (p - armpit_).norm() < 0.03 * finder_.scan.height(); })) {
      continue;
    }
    for (const Vec3& p : piece.points) {
      if ((p - shoulder_).dot(up) > 0.0) {
        shoulder_ = p;
      }
    }
  }
  finder_.add(name("shoulder"), shoulder_);
}

void Arm::find() {
  constexpr double least_bend = 8.0 * M_PI / 180.0, elbow_share = 0.56;
  const FigureScan& scan = finder_.scan;
  const std::vector<ArmStation> line = arm_line(scan, armpit_, side_);
  Vec3 start;
  find_shoulder(first_direction(scan, armpit_, side_, &start));
  if (line.size() < 12) {
    miss_below_shoulder("the arm ends near the shoulder, or its sections do not part from the trunk's");
    return;
  }
  const int wrist = wrist_of(line);
  if (wrist < 8) {
    miss_below_shoulder("the girth of the arm has no smallest value before the hand");
    return;
  }
  const double shoulder = (shoulder_ - line[0].centre).dot(line[0].direction);
  double angle = 0.0;
  int elbow = bend_of(line, wrist, &angle);
  if (angle < least_bend) {  // a straight arm does not show it
    const double along = std::min(shoulder + elbow_share * (line[wrist].along - shoulder), line[wrist].along);
    elbow = 0;
    while (line[elbow].along < along) {
      ++elbow;
    }
  }
  const double half = std::min(0.5 * (shoulder + line[elbow].along), line[elbow].along);
  int upper = 0;
  while (line[upper].along < half) {
    ++upper;
  }
  add("upper arm", line[upper]);
  add("elbow", line[elbow]);
  add("wrist", line[wrist]);
}

}  // namespace

void find_arms(const Finder& finder) {
  for (const int side : {1, -1}) {
    const Landmark* armpit = finder.find(std::string(side_name(side)) + "armpit");
    if (armpit == nullptr) {
      for (const char* part : {"shoulder", "upper arm", "elbow", "wrist"}) {
        finder.miss(side_name(side) + std::string(part), "the armpit, from which the arm is followed, was not found");
      }
      continue;
    }
    const Vec3 point = armpit->point;
    Arm(finder, side, point).find();
  }
}

}  // namespace toile::body
