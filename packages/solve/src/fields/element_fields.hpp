#pragma once

#include <vector>

#include "toile/solve/output_fields.hpp"

namespace toile::solve {

/// The declared fields of elements.
std::vector<OutputField> declared_element_fields();

/// A value an element of one block: `points` belong to `elements` elements of fabric that is `thickness` mm thick.
/// `crossing`: [element] length of the lines along which it crosses fabric, mm; null if these are not looked for.
std::vector<NamedField> element_values(const Problem& problem, const element::PointFields& points, int elements,
                                       double thickness, const double* crossing);

}  // namespace toile::solve
