#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "toile/base/parameters.hpp"

namespace toile::scene {

/// The section of a limb at a level.
struct LimbSection {
  std::string problem;          ///< why it tells nothing; empty: it does
  double radius = 0.0;          ///< mm
  double laplace = 0.0;         ///< MPa, tension over radius
  double pressure_error = 0.0;  ///< MPa, of the mean pressure round it
};

/// What a run has found, as far as testers ask for it.
class WornGarment {
 public:
  WornGarment() = default;
  WornGarment(const WornGarment&) = delete;
  WornGarment& operator=(const WornGarment&) = delete;
  virtual ~WornGarment() = default;
  /// N, of a support of the scene.
  virtual double force(const std::string& support) const = 0;
  /// At a level of the scene.
  virtual LimbSection section(const std::string& level) const = 0;
};

/// MPa.
struct TesterReading {
  std::string problem;    ///< why there is no reading; empty: there is one
  double pressure = 0.0;  ///< by Laplace's law, of the limb without a tester
  double error = 0.0;     ///< of the reading, by what is known of the pressure's
  double reading = 0.0;
};

/// A tester of a hosiery laboratory. Each kind is a source of its own, with a line in the registry (testers.cpp).
class Tester {
 public:
  explicit Tester(std::string name) : name_(std::move(name)) {}
  Tester(const Tester&) = delete;
  Tester& operator=(const Tester&) = delete;
  virtual ~Tester() = default;
  const std::string& name() const { return name_; }
  virtual TesterReading read(const WornGarment& garment) const = 0;

 private:
  std::string name_;
};

/// Names of the scene that a tester can be at.
struct TesterPlaces {
  base::Texts supports, levels;
};

/// Of one entry of the list "Testers".
base::Spec tester_spec();
/// Throws base::InputError if it is at a place that is not there.
std::shared_ptr<const Tester> read_tester(const base::List& entry, const TesterPlaces& places);

}  // namespace toile::scene
