#pragma once

#include <string>

namespace toile::result {

/// A field or column with the unit of its values.
struct FieldName {
  std::string name;
  std::string unit;  ///< empty: dimensionless
};

}  // namespace toile::result
