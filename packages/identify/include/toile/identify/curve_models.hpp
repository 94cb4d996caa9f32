#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "toile/identify/curve.hpp"
#include "toile/identify/forward_model.hpp"

namespace toile::identify {

/// What a curve is evaluated with.
enum class Fidelity : std::uint8_t {
  as_asked,     ///< the model that the curve asks for
  homogeneous,  ///< homogeneous states, whatever it asks for: some thousand times as fast as finite elements
};

/// Forward model of all points of `curves`, one curve after the other. All homogeneous curves are one batch, and if
/// there are no others, no mesh is built.
std::unique_ptr<ForwardModel> forward_model(const std::vector<Curve>& curves, Fidelity fidelity = Fidelity::as_asked);

}  // namespace toile::identify
