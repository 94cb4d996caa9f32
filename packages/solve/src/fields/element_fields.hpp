#pragma once

#include <vector>

#include "toile/solve/output_fields.hpp"

namespace toile::solve {

/// The declared fields of elements.
std::vector<OutputField> declared_element_fields();

/// A value an element of one block: `points` belong to `elements` elements of fabric that is `thickness` mm thick.
std::vector<NamedField> element_values(const Problem& problem, const element::PointFields& points, int elements,
                                       double thickness);

}  // namespace toile::solve
