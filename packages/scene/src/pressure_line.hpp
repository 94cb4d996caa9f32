#pragma once

#include <string>

#include "toile/base/parameters.hpp"
#include "toile/scene/scene.hpp"

namespace toile::scene {

base::Spec lines_spec();

/// Where a point of the scene lies on the body: on its smooth surface. Fails, naming `parameter`, if it is further than
/// 20 mm from the skin.
BodyPoint place_on_body(const base::List& entry, const std::string& parameter, const solve::Vec3& point,
                        const body::Surface* surface);

/// The entries of "Lines". `output`: its axis and the size of the body's triangles, on which the lines are found.
std::vector<PressureLine> read_lines(const base::List& list, const body::Surface* surface, const Output& output);

}  // namespace toile::scene
