#pragma once

#include "toile/criteria/criterion.hpp"

namespace toile::criteria {

/// `n` states spread evenly over the box (Mersenne twister, fixed seed: the same for every call).
std::vector<Strain> random_states(const Request& request, int n);

/// R^T C R, R a rotation by `angle` (rad).
Strain turned(const Strain& C, double angle);

}  // namespace toile::criteria
