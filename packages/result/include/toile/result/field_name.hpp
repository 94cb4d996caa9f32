#pragma once

#include <string>
#include <vector>

namespace toile::result {

/// A field or column with the unit of its values.
struct FieldName {
  std::string name;
  std::string unit;       ///< empty: dimensionless
  std::string text = {};  ///< what it means, where fields are listed
};

/// The nodal fields that every Exodus file of a garment has: displacement and pattern coordinates.
const std::vector<FieldName>& geometry_fields();

/// On the body's nodes, if its surface was fitted to them.
const FieldName& body_error_field();

}  // namespace toile::result
