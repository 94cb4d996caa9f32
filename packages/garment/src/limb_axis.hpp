#pragma once

#include <memory>
#include <optional>

#include "section.hpp"
#include "toile/base/parameters.hpp"
#include "toile/body/body.hpp"
#include "toile/mesh/bent_axis.hpp"

namespace toile::garment {

/// The axis that a panel is wrapped round: straight, or that of a bent limb. Heights (mm) count along it.
class LimbAxis {
 public:
  /// Reads "axis bottom" and "axis top", or "axis" and "smoothing", and "zero direction". Throws InputError.
  explicit LimbAxis(const base::List& placement);

  /// Point, direction and zero of angles at a height: a straight axis that touches this one there.
  Axis frame(double height) const;
  /// Derivative of the direction by the height, 1/mm.
  body::Vec3 curvature(double height) const;
  bool is_bent() const { return bent_.has_value(); }
  /// Parameter to name when something is wrong with it.
  const char* parameter() const { return is_bent() ? "axis" : "axis bottom"; }

 private:
  Axis straight_;
  std::optional<mesh::BentAxis> bent_;
};

base::Spec& add_axis_parameters(base::Spec& spec);

}  // namespace toile::garment
