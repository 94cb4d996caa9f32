#pragma once

#include <optional>
#include <vector>

#include "toile/contact/recovery.hpp"

namespace toile::contact {

/// Which tension of a point.
enum class Tension { of_facet, laid };

/// Pressure (tension x curvature) at `place` on a surface with this normal and curvature (Hessian of the gap), from an
/// area-weighted least-squares fit of the tangential tension of some elements: of the means of quadrilaterals, and of
/// the means of two triangles on either side of an edge. Each point's tension is turned into the tangent plane by the
/// least rotation of its normal. `degree` 0: the mean; 1: linear; 2: quadratic.
/// Nothing if the points do not determine the fit.
std::optional<double> fitted_pressure(const FabricInContact& fabric, const std::vector<int>& patch,
                                      const ContactCluster& place, Tension tension, int degree);

}  // namespace toile::contact
