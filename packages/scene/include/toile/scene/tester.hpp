#pragma once

#include <string>
#include <variant>

#include "toile/base/parameters.hpp"

namespace toile::scene {

/// Two flat jaws, or legs of wood, over which a stocking is drawn and which are driven apart. The tester tells the
/// pressure on a limb of the girth that the stocking then has, by Laplace's law.
struct FlatJaws {
  std::string support;  ///< that holds the fabric on one of the jaws
  double width = 0.0;   ///< of the jaws, mm
  double girth = 0.0;   ///< of the limb, mm

  /// MPa, of the force of the fabric's one layer on the support, N.
  double pressure(double force) const;
};

/// A rigid sensor between the fabric and the limb at a level, with its longer edges along the limb.
struct RigidSensor {
  std::string level;
  double width = 0.0;   ///< round the limb, mm
  double height = 0.0;  ///< mm

  /// Its reading over the pressure T/R of the bare limb: 2 R sin(beta) / b, beta = atan(b / (2 (R + h))) + acos(R /
  /// sqrt(b^2/4 + (R + h)^2)), if the fabric slides without friction, so that its tension T is the same everywhere.
  double ratio(double radius) const;
};

struct Tester {
  std::string name;
  std::variant<FlatJaws, RigidSensor> kind;
};

/// Of one entry of the list "Testers".
base::Spec tester_spec();
Tester read_tester(const base::List& entry);

}  // namespace toile::scene
