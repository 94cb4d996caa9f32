#include "figure/fit_girths.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "figure/operators.hpp"
#include "toile/base/error.hpp"
#include "toile/body/section.hpp"
#include "toile/body/triangle_tree.hpp"

namespace toile::body {
namespace {

constexpr double wanted_error = 0.003, largest_error = 0.008;  // of a measurement
constexpr int most_rounds = 15, quick_rounds = 5;
const char* const shoulder_width = "shoulder width";

/// A point of the form as its facets' corners have it, and where it goes.
struct Anchor {
  std::array<int, 3> corners;
  Vec3 shares;
  Vec3 point;
  double weight = 0.0;  ///< length that it stands for, mm
};

/// A section that is scaled.
struct Ring {
  std::string landmark;     ///< empty: it has none
  std::string measurement;  ///< empty: it follows others
  /// Rings whose factors make its own, with their powers.
  std::vector<std::pair<std::string, double>> follows;
  int side = 0;         ///< +1 left, -1 right, 0 middle
  bool of_arm = false;  ///< moves with the shoulder
  Vec3 normal, centre;  ///< about which it is scaled
  Vec3 inner, back;     ///< of the section, level with its centre: nearest to the body's middle, hindmost
  double girth = 0.0;   ///< of the form
  double factor = 1.0;
  std::vector<Anchor> anchors;
};

bool is_of_leg(const std::string& name) {
  return name == "thigh" || name == "knee" || name == "calf" || name == "ankle";
}

bool is_of_arm(const std::string& name) {
  return name == "upper arm" || name == "wrist";
}

double shoulder_width_of(const Landmarks& landmarks) {
  return (landmarks.at("left shoulder").point - landmarks.at("right shoulder").point).norm();
}

class Fit {
 public:
  Fit(const TriangleMesh& form, const std::vector<Measurement>& measurements)
      : form_(form), landmarks_(find_landmarks(form)), tree_(form), sections_(form), measurements_(measurements) {
    for (const Measurement& m : measurements) {
      add_rings(m.name);
    }
    for (const int side : {1, -1}) {
      add_followers(side);
      add_shoulder(side);
    }
    factorise();
  }
  GirthFit run();

 private:
  void add_rings(const std::string& measurement);
  Ring ring_at(const Vec3& point, const Vec3& normal, int side);
  void add_ring(const std::string& name, const std::string& measurement, int side);
  void add_followers(int side);
  void add_shoulder(int side);
  Anchor anchor_at(const Vec3& point, double weight) const;
  void factorise();
  Vec3 target(const Ring& ring, const Vec3& point) const;
  TriangleMesh moved() const;
  /// Measures, and corrects a share of what is missing; returns the largest relative error.
  double correct(const Landmarks& landmarks, const TriangleMesh& mesh, double share);
  void correct_rings(const Landmarks& landmarks, const TriangleMesh& mesh, double share, Measurement* m);
  /// At the landmark; where the changed form does not show it, as an underbust without a fold, at the ring itself.
  double girth_of(const Ring& ring, const Landmarks& landmarks, const TriangleMesh& mesh) const;
  double factor_of(const std::string& landmark) const;

  const TriangleMesh& form_;
  Landmarks landmarks_;
  TriangleTree tree_;
  Sections sections_;
  std::vector<Measurement> measurements_;
  std::vector<Ring> rings_;
  std::vector<std::pair<int, Anchor>> shoulders_;  ///< side, point
  double shift_ = 0.0;                             ///< of each shoulder outwards, mm
  Eigen::SimplicialLDLT<SparseMatrix> solver_;
};

Anchor Fit::anchor_at(const Vec3& point, double weight) const {
  const TriangleTree::Hit hit = tree_.closest(point);
  return {form_.triangles[hit.triangle], hit.barycentric, point, weight};
}

void Fit::add_rings(const std::string& measurement) {
  if (measurement == "height" || measurement == shoulder_width) {
    return;
  }
  if (!is_of_leg(measurement) && !is_of_arm(measurement)) {
    add_ring(measurement, measurement, 0);
    return;
  }
  add_ring("left " + measurement, measurement, 1);
  add_ring("right " + measurement, measurement, -1);
}

/// The section whose centre is nearest to a point.
Ring Fit::ring_at(const Vec3& point, const Vec3& normal, int side) {
  const auto pieces = sections_.cut(point, normal);
  const auto piece = std::min_element(pieces.begin(), pieces.end(), [&point](const auto& a, const auto& b) {
    return (a.centre - point).norm() < (b.centre - point).norm();
  });
  Ring ring;
  ring.side = side;
  ring.normal = normal;
  ring.centre = piece->centre;
  ring.inner = {side > 0 ? piece->lower.x() : piece->upper.x(), piece->centre.y(), piece->centre.z()};
  ring.back = {piece->centre.x(), piece->upper.y(), piece->centre.z()};
  ring.girth = piece->tape_girth;
  const auto& points = piece->points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 &before = points[(i + points.size() - 1) % points.size()], &next = points[(i + 1) % points.size()];
    ring.anchors.push_back(anchor_at(points[i], 0.5 * ((points[i] - before).norm() + (next - points[i]).norm())));
  }
  return ring;
}

void Fit::add_ring(const std::string& name, const std::string& measurement, int side) {
  // How much of a leg's widening goes to the outside, so that thighs do not come together.
  const double outwards = measurement == "thigh" ? 1.0 : measurement == "knee" ? 0.4 : 0.0;
  const Landmark& landmark = landmarks_.at(name);
  Ring ring = ring_at(landmark.point, landmark.normal, side);
  ring.landmark = name;
  ring.measurement = measurement;
  ring.of_arm = is_of_arm(measurement);
  ring.centre += outwards * (ring.inner - ring.centre);
  rings_.push_back(std::move(ring));
}

/// Between the measurements of a limb, so that it stays as smooth as it is, and at the end of the arm.
void Fit::add_followers(int side) {
  constexpr double to_end = 12.0;  // mm beyond the wrist
  const std::string name = side > 0 ? "left " : "right ";
  const Landmark &elbow = landmarks_.at(name + "elbow"), &wrist = landmarks_.at(name + "wrist");
  const Vec3 normal = (elbow.normal + wrist.normal).normalized();
  Ring at_elbow = ring_at(elbow.point, elbow.normal, side);
  at_elbow.follows = {{name + "upper arm", 0.5}, {name + "wrist", 0.5}};
  Ring forearm = ring_at(0.5 * (elbow.point + wrist.point), normal, side);
  forearm.follows = {{name + "upper arm", 0.25}, {name + "wrist", 0.75}};
  Ring end = ring_at(wrist.point + to_end * wrist.normal, wrist.normal, side);
  end.follows = {{name + "wrist", 1.0}};
  for (Ring* ring : {&at_elbow, &forearm, &end}) {
    ring->of_arm = true;
    rings_.push_back(std::move(*ring));
  }
  const auto add_between = [&](const std::string& above, const std::string& below, double outwards) {
    const Vec3 middle = 0.5 * (landmarks_.at(name + above).point + landmarks_.at(name + below).point);
    Ring ring = ring_at(middle, Vec3::UnitZ(), side);
    ring.centre += outwards * (ring.inner - ring.centre);
    ring.follows = {{name + above, 0.5}, {name + below, 0.5}};
    rings_.push_back(std::move(ring));
  };
  add_between("thigh", "knee", 0.7);
  add_between("calf", "ankle", 0.0);
}

void Fit::add_shoulder(int side) {
  constexpr double around = 25.0;  // mm
  const Vec3 point = landmarks_.at(side > 0 ? "left shoulder" : "right shoulder").point;
  for (const Vec3& v : form_.vertices) {
    if ((v - point).norm() < around) {
      shoulders_.emplace_back(side, anchor_at(v, 0.2 * around));
    }
  }
}

/// Bending of the displacement, and springs that hold the anchors where they should be.
void Fit::factorise() {
  constexpr double stiffness = 0.05;  // 1/mm^3
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&entries](Anchor* anchor) {
    anchor->weight *= stiffness;
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        entries.emplace_back(anchor->corners[a], anchor->corners[b],
                             anchor->weight * anchor->shares[a] * anchor->shares[b]);
      }
    }
  };
  for (Ring& ring : rings_) {
    for (Anchor& anchor : ring.anchors) {
      add(&anchor);
    }
  }
  for (auto& [side, anchor] : shoulders_) {
    add(&anchor);
  }
  SparseMatrix springs(form_.vertices.size(), form_.vertices.size());
  springs.setFromTriplets(entries.begin(), entries.end());
  solver_.compute(bending_of(form_) + springs);
  if (solver_.info() != Eigen::Success) {
    throw base::InputError("the form of the body cannot be changed: it has facets without area");
  }
}

double Fit::factor_of(const std::string& landmark) const {
  return std::find_if(rings_.begin(), rings_.end(), [&](const Ring& r) { return r.landmark == landmark; })->factor;
}

/// Displacement that a point of a ring should have.
Vec3 Fit::target(const Ring& ring, const Vec3& point) const {
  const auto across = [&ring](const Vec3& away) { return Vec3(away - ring.normal.dot(away) * ring.normal); };
  if (ring.measurement == "bust") {
    // With the underbust all round, and beyond that to the front.
    const double all = factor_of("underbust") - 1.0;
    return all * across(point - ring.centre) + (ring.factor - 1.0 - all) * across(point - ring.back);
  }
  double factor = ring.factor;
  for (const auto& [landmark, power] : ring.follows) {
    factor *= std::pow(factor_of(landmark), power);
  }
  const Vec3 shift(ring.of_arm ? ring.side * shift_ : 0.0, 0.0, 0.0);
  return (factor - 1.0) * across(point - ring.centre) + shift;
}

TriangleMesh Fit::moved() const {
  Eigen::MatrixX3d forces = Eigen::MatrixX3d::Zero(form_.vertices.size(), 3);
  const auto pull = [&forces](const Anchor& anchor, const Vec3& target) {
    for (int i = 0; i < 3; ++i) {
      forces.row(anchor.corners[i]) += anchor.weight * anchor.shares[i] * target.transpose();
    }
  };
  for (const Ring& ring : rings_) {
    for (const Anchor& anchor : ring.anchors) {
      pull(anchor, target(ring, anchor.point));
    }
  }
  for (const auto& [side, anchor] : shoulders_) {
    pull(anchor, Vec3(side * shift_, 0.0, 0.0));
  }
  const Eigen::MatrixX3d displacement = solver_.solve(forces);
  TriangleMesh mesh = form_;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    mesh.vertices[v] += displacement.row(v).transpose();
  }
  return mesh;
}

double Fit::girth_of(const Ring& ring, const Landmarks& landmarks, const TriangleMesh& mesh) const {
  if (const Landmark* landmark = landmarks.find(ring.landmark)) {
    return landmark->girth;
  }
  Vec3 centre = Vec3::Zero();
  for (const Anchor& anchor : ring.anchors) {
    for (int i = 0; i < 3; ++i) {
      centre += anchor.shares[i] / static_cast<double>(ring.anchors.size()) * mesh.vertices[anchor.corners[i]];
    }
  }
  const auto pieces = Sections(mesh).cut(centre, ring.normal);
  const auto piece = std::min_element(pieces.begin(), pieces.end(), [&centre](const auto& a, const auto& b) {
    return (a.centre - centre).norm() < (b.centre - centre).norm();
  });
  return piece == pieces.end() ? 0.0 : piece->tape_girth;
}

double Fit::correct(const Landmarks& landmarks, const TriangleMesh& mesh, double share) {
  double worst = 0.0;
  for (Measurement& m : measurements_) {
    if (m.name == "height") {
      m.reached = m.value;
    } else if (m.name == shoulder_width) {
      m.reached = shoulder_width_of(landmarks);
      shift_ += share * 0.5 * (m.value - m.reached);
    } else {
      correct_rings(landmarks, mesh, share, &m);
    }
    worst = std::max(worst, std::abs(m.reached - m.value) / m.value);
  }
  return worst;
}

void Fit::correct_rings(const Landmarks& landmarks, const TriangleMesh& mesh, double share, Measurement* m) {
  // Of left and right the one that is further off is told.
  double worst = -1.0;
  for (Ring& ring : rings_) {
    if (ring.measurement != m->name) {
      continue;
    }
    const double girth = girth_of(ring, landmarks, mesh);
    ring.factor += share * (m->value - girth) / ring.girth;
    if (std::abs(girth - m->value) > worst) {
      worst = std::abs(girth - m->value);
      m->reached = girth;
    }
  }
}

GirthFit Fit::run() {
  GirthFit best;
  double least = HUGE_VAL;
  for (int round = 1; round <= most_rounds && least > wanted_error; ++round) {
    TriangleMesh mesh = moved();
    Landmarks landmarks = find_landmarks(mesh);
    // A landmark may jump from facet to facet: then smaller steps.
    const double worst = correct(landmarks, mesh, round > quick_rounds ? 0.5 : 1.0);
    if (worst < least) {
      least = worst;
      best = {std::move(mesh), std::move(landmarks), measurements_, round};
    }
  }
  if (least <= largest_error) {
    return best;
  }
  std::ostringstream text;
  text.precision(4);
  text << "the body cannot be changed to these measurements; after " << most_rounds << " rounds";
  const char* separator = " ";
  for (const Measurement& m : best.measurements) {
    if (std::abs(m.reached - m.value) > largest_error * m.value) {
      text << separator << m.name << " is " << 0.1 * m.reached << " cm instead of " << 0.1 * m.value << " cm";
      separator = ", ";
    }
  }
  throw base::InputError(text.str());
}

}  // namespace

GirthFit fit_girths(const TriangleMesh& form, const std::vector<Measurement>& measurements) {
  return Fit(form, measurements).run();
}

}  // namespace toile::body
