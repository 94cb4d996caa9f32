#include <algorithm>
#include <cmath>
#include <optional>

#include "figure/scan.hpp"

namespace toile::body {
namespace {

/// Foremost (sign -1) or hindmost (+1) y of a curve at x; none if it does not reach there.
std::optional<double> outline_at(const SectionPiece& piece, double x, double sign) {
  std::optional<double> best;
  for (std::size_t i = 0; i < piece.points.size(); ++i) {
    const Vec3 &a = piece.points[i], &b = piece.points[(i + 1) % piece.points.size()];
    if ((a.x() < x) == (b.x() < x)) {
      continue;
    }
    const double y = a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
    if (!best || sign * y > sign * *best) {
      best = y;
    }
  }
  return best;
}

/// The search of the trunk's landmarks between crotch and armpits.
class Trunk {
 public:
  explicit Trunk(const Finder& finder) : finder_(finder), scan_(finder.scan) {
    const Landmark* crotch = finder.find("crotch");
    bottom_ = crotch != nullptr ? crotch->point.z() : scan_.bottom();
    const Landmark *left = finder.find("left armpit"), *right = finder.find("right armpit");
    const Landmark* neck = finder.find("neck");
    if (left != nullptr && right != nullptr) {
      top_ = 0.5 * (left->point.z() + right->point.z());
      half_width_ = 0.5 * (left->point.x() - right->point.x());
    } else if (neck != nullptr) {
      // The armpits are about a quarter of the way from the neck to the crotch.
      top_ = neck->point.z() - 0.27 * (neck->point.z() - bottom_);
      const FigureLevel level = scan_.level(top_);
      half_width_ = level.trunk < 0 ? 0.0 : 0.5 * (level.trunk_piece()->upper.x() - level.trunk_piece()->lower.x());
    }
  }
  bool known() const { return top_ > bottom_ && half_width_ > 0.0; }
  void find_hip() const;
  void find_waist() const;
  void find_bust() const;
  void find_underbust() const;
  void find_blades() const;

 private:
  double length() const { return top_ - bottom_; }
  /// The point furthest to the front (-1) or back (+1) on one side, at heights between `from` and `to`.
  struct Prominence {
    Vec3 point;
    bool inside = false;  ///< not at an end of the heights
  };
  std::optional<Prominence> most_prominent(double sign, int side, double from, double to) const;
  std::optional<Vec3> furthest_of(const FigureLevel& level, double sign, int side) const;

  const Finder& finder_;
  const FigureScan& scan_;
  double bottom_ = 0.0, top_ = 0.0, half_width_ = 0.0;
};

std::optional<Trunk::Prominence> Trunk::most_prominent(double sign, int side, double from, double to) const {
  constexpr double near = 1e-3;  // of the height
  std::vector<Vec3> furthest;    // of each level
  std::size_t best = 0;
  for (int i = scan_.index(from) + 1; i <= scan_.index(to); ++i) {
    const auto point = furthest_of(scan_.levels()[i], sign, side);
    if (point) {
      furthest.push_back(*point);
      best = sign * point->y() > sign * furthest[best].y() ? furthest.size() - 1 : best;
    }
  }
  if (furthest.empty()) {
    return {};
  }
  // The mean of what stands out nearly as much, so that single vertices do not decide.
  const double least = sign * furthest[best].y() - near * scan_.height();
  const auto weight = [&](std::size_t k) { return std::max(0.0, sign * furthest[k].y() - least); };
  double sum = weight(best);
  Vec3 mean = sum * furthest[best];
  for (std::size_t k = best + 1; k < furthest.size() && weight(k) > 0.0; ++k) {
    sum += weight(k);
    mean += weight(k) * furthest[k];
  }
  for (std::size_t k = best; k-- > 0 && weight(k) > 0.0;) {
    sum += weight(k);
    mean += weight(k) * furthest[k];
  }
  return Prominence{mean / sum, best > 0 && best + 1 < furthest.size()};
}

std::optional<Vec3> Trunk::furthest_of(const FigureLevel& level, double sign, int side) const {
  std::optional<Vec3> furthest;
  if (level.trunk < 0) {
    return furthest;
  }
  for (const Vec3& p : level.trunk_piece()->points) {
    const double away = side * (p.x() - scan_.middle());
    const bool counts = away >= 0.1 * half_width_ && away <= half_width_;
    if (counts && (!furthest || sign * p.y() > sign * furthest->y())) {
      furthest = p;
    }
  }
  return furthest;
}

void Trunk::find_hip() const {
  // Where the buttocks stand out most; without them the largest girth.
  const double from = bottom_ + 0.02 * length(), to = bottom_ + 0.45 * length();
  const auto left = most_prominent(1.0, 1, from, to), right = most_prominent(1.0, -1, from, to);
  if (left && right && left->inside && right->inside) {
    finder_.add_trunk_level("hip", 0.5 * (left->point.z() + right->point.z()));
    return;
  }
  double most = 0.0, z = from;
  for (int i = scan_.index(from) + 1; i <= scan_.index(to); ++i) {
    const SectionPiece* trunk = scan_.levels()[i].trunk_piece();
    if (trunk != nullptr && trunk->tape_girth > most) {
      most = trunk->tape_girth;
      z = scan_.levels()[i].z;
    }
  }
  finder_.add_trunk_level("hip", z);
}

void Trunk::find_waist() const {
  const Landmark* hip = finder_.find("hip");
  const double from = hip != nullptr ? hip->point.z() : bottom_, to = top_ - 0.1 * length();
  int least = -1;
  const int first = scan_.index(from) + 1, last = scan_.index(to);
  for (int i = first; i <= last; ++i) {
    const SectionPiece* trunk = scan_.levels()[i].trunk_piece();
    if (trunk != nullptr && (least < 0 || trunk->tape_girth < scan_.levels()[least].trunk_piece()->tape_girth)) {
      least = i;
    }
  }
  if (least < 0 || least == first || least == last) {
    finder_.miss("waist", "no height between hip and armpits has the smallest girth of the trunk");
    return;
  }
  finder_.add_trunk_level("waist", scan_.levels()[least].z);
}

void Trunk::find_bust() const {
  double sum = 0.0;
  int count = 0;
  for (const int side : {1, -1}) {
    const std::string name = std::string(side_name(side)) + "bust point";
    const auto point = most_prominent(-1.0, side, top_ - 0.31 * length(), top_ + 0.1 * length());
    if (!point || !point->inside) {
      finder_.miss(name, "nothing of the chest stands out to the front between the waist and the armpit");
      continue;
    }
    finder_.add(name, point->point);
    sum += point->point.z();
    ++count;
  }
  if (count == 2) {
    finder_.add_trunk_level("bust", 0.5 * sum);
  } else {
    finder_.miss("bust", "a bust point was not found");
  }
}

void Trunk::find_underbust() const {
  constexpr double least_fold = 1e-3;  // of the height
  const Landmark* waist = finder_.find("waist");
  double sum = 0.0;
  int count = 0;
  for (const int side : {1, -1}) {
    const Landmark* bust = finder_.find(std::string(side_name(side)) + "bust point");
    if (bust == nullptr || waist == nullptr) {
      continue;
    }
    const Vec3& top = bust->point;
    const FigureLevel waist_level = scan_.level(waist->point.z());
    const auto front = outline_at(*waist_level.trunk_piece(), top.x(), -1.0);
    if (!front) {
      continue;
    }
    // The deepest place behind the line from the bust point to the front of the waist; the mean of what is nearly as
    // deep, so that the place does not jump from facet to facet.
    Course depths;
    double deepest = least_fold * scan_.height();
    bool has_fold = false;
    for (int i = scan_.index(waist->point.z()) + 1; i <= scan_.index(top.z()); ++i) {
      const FigureLevel& level = scan_.levels()[i];
      const auto y = level.trunk < 0 ? std::nullopt : outline_at(*level.trunk_piece(), top.x(), -1.0);
      if (!y) {
        continue;
      }
      const double share = (level.z - waist->point.z()) / (top.z() - waist->point.z());
      depths.emplace_back(level.z, *y - (*front + share * (top.y() - *front)));
      has_fold = has_fold || depths.back().second > deepest;
      deepest = std::max(deepest, depths.back().second);
    }
    if (has_fold) {
      sum += mean_place(depths, [deepest](double depth) { return std::max(0.0, depth - 0.8 * deepest); });
      ++count;
    }
  }
  if (count == 2) {
    finder_.add_trunk_level("underbust", 0.5 * sum);
  } else {
    finder_.miss("underbust", "there is no fold below the bust points, or they or the waist were not found");
  }
}

void Trunk::find_blades() const {
  for (const int side : {1, -1}) {
    const std::string name = std::string(side_name(side)) + "shoulder blade";
    const auto point = most_prominent(1.0, side, top_ - 0.2 * length(), top_ + 0.3 * length());
    if (point && point->inside) {
      finder_.add(name, point->point);
    } else {
      finder_.miss(name, "nothing of the back stands out near the armpit");
    }
  }
}

}  // namespace

void find_trunk(const Finder& finder) {
  const Trunk trunk(finder);
  if (!trunk.known()) {
    for (const char* name : {"hip", "waist", "left bust point", "right bust point", "bust", "underbust",
                             "left shoulder blade", "right shoulder blade"}) {
      finder.miss(name, "where the trunk ends is not known, for neither both armpits nor the neck were found");
    }
    return;
  }
  trunk.find_hip();
  trunk.find_waist();
  trunk.find_bust();
  trunk.find_underbust();
  trunk.find_blades();
}

}  // namespace toile::body
