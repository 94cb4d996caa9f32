#pragma once

#include <vector>

#include "cutter.hpp"

namespace toile::result {

/// Groups of sections (indices, rising) that lie over each other for most of their length, as layers of one limb do;
/// only groups of at least two.
std::vector<std::vector<std::size_t>> layers(const std::vector<Section>& sections);

/// The longest of the layers with what all of them do at each place of it: pressure, its error and tension are added.
Section sum_of(const std::vector<const Section*>& layers);

}  // namespace toile::result
