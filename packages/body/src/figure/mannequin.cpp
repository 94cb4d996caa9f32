#include "toile/body/mannequin.hpp"

#include <algorithm>

#include "figure/fit_girths.hpp"
#include "figure/form.hpp"
#include "figure/turn_arms.hpp"
#include "toile/base/error.hpp"
#include "toile/body/section.hpp"

namespace toile::body {
namespace {

/// The body at another height, its floor at z = 0 and its middle at x = 0.
TriangleMesh scaled(const TriangleMesh& body, const Landmarks& landmarks, double height) {
  const double floor = extent_of(body).lower.z();
  const Vec3 crown = landmarks.at("crown").point, middle(landmarks.at("waist").point.x(), 0.0, floor);
  TriangleMesh result = body;
  for (Vec3& v : result.vertices) {
    v = height / (crown.z() - floor) * (v - middle);
  }
  return result;
}

}  // namespace

Mannequin make_mannequin(const TriangleMesh& body, const std::vector<Measurement>& measurements,
                         const MannequinOptions& options) {
  const auto height =
      std::find_if(measurements.begin(), measurements.end(), [](const Measurement& m) { return m.name == "height"; });
  const TriangleMesh sized = scaled(body, find_landmarks(body), height->value);
  TriangleMesh form = dress_form(sized, find_landmarks(sized), options.edge);
  if (options.arm_angle) {
    form = turn_arms(form, find_landmarks(form), *options.arm_angle);
    check_intersections(form, "with the arms at this angle");
  }
  GirthFit fit = fit_girths(form, measurements);
  check_intersections(fit.mesh, options.arm_angle ? "with these measurements and arms" : "with these measurements");
  Mannequin mannequin;
  mannequin.arm_angle = arm_angle(fit.landmarks);
  mannequin.mesh = std::move(fit.mesh);
  mannequin.landmarks = std::move(fit.landmarks);
  mannequin.measurements = std::move(fit.measurements);
  mannequin.rounds = fit.rounds;
  return mannequin;
}

}  // namespace toile::body
