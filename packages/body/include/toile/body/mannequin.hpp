#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/body/landmarks.hpp"
#include "toile/body/surface.hpp"

namespace toile::body {

/// A measurement that a mannequin is made to.
struct Measurement {
  std::string name;      ///< "height", "shoulder width" or a landmark's, whose tape girth it is
  double value = 0.0;    ///< mm
  std::string source;    ///< why it has this value: "given", "default" or the measurement that it follows
  double reached = 0.0;  ///< mm, of the finished mannequin
};

/// Names of all measurements, in the order from the top down.
const base::Texts& measurement_names();

/// All measurements, from those that are given: an average woman of 20 years (158 cm, 83/64/90 cm) if none is. Others
/// follow: lengths the height, girths of the upper body the bust, those of the legs the hip. Throws InputError for a
/// name that is none, and for values that contradict each other or are no body's.
std::vector<Measurement> complete_measurements(const std::map<std::string, double>& given);

struct MannequinOptions {
  std::optional<double> arm_angle;  ///< of the upper arms below the level, degrees; none: as the body holds them
  double edge = 10.0;               ///< of the facets, mm
};

struct Mannequin {
  TriangleMesh mesh;  ///< closed, without head, hands and feet
  Landmarks landmarks;
  std::vector<Measurement> measurements;  ///< with what was reached
  double arm_angle = 0.0;                 ///< degrees below the level
  int rounds = 0;                         ///< of fitting
};

/// Makes a smooth dress form of a body and changes it until every measurement is reached within 0.8 %: the girths at
/// the landmarks that find_landmarks() finds on the finished form. Its floor is at z = 0, below the feet that it lacks.
/// Throws InputError: landmarks that the body lacks, measurements that it cannot be changed to, arms that would touch.
Mannequin make_mannequin(const TriangleMesh& body, const std::vector<Measurement>& measurements,
                         const MannequinOptions& options);

}  // namespace toile::body
