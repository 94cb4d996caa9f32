// Numbers, places and messages, as the start report words them.
#pragma once

#include <string>

#include "toile/base/parameters.hpp"
#include "toile/solve/problem.hpp"

namespace toile::scene {

/// Three digits, whole numbers from 1000 on.
std::string short_number(double value);
/// "(x, y, z) mm".
std::string place_text(const solve::Vec3& place);
/// The message that List::fail throws.
std::string message_of(const base::List& entry, const std::string& parameter, const std::string& problem);

}  // namespace toile::scene
