#pragma once

#include "toile/criteria/criterion.hpp"

namespace toile::criteria {

/// W(I) = 0, S(I) = 0, no change of thickness, and a positive definite tangent at C = I.
Finding natural_state(const Fabric& fabric);

/// A clean refusal or finite numbers, never a NaN that no status tells of: the box of `request`, and states of random
/// orientation with principal stretches 0.3 to 5 or a simple shear up to 3 on top of them; the outputs of a refused
/// point are NaN, and so is no other.
Finding finite_numbers(const Fabric& fabric, const Request& request);

/// S against W and D against S by one-sided and central differences with Richardson extrapolation at random states of
/// the box (the best of the three: a law may have a kink, as where a fibre goes slack), and dS1/dE2 = dS2/dE1 and so on
/// of the differences, without which there is no energy.
Finding derivatives(const Fabric& fabric, const Request& request);

/// W and S of the mirror image (orthotropic), W of C turned by random angles (isotropic). Symmetry::none only tells.
Finding material_symmetry(const Fabric& fabric, const Request& request);

/// W grows on the way from C = I to stretches of 20 and down to where the law ends (stretch 0.05 or its own limit), in
/// wale, course and both.
Finding growth(const Fabric& fabric);

}  // namespace toile::criteria
