#include "toile/result/field_name.hpp"

namespace toile::result {

const std::vector<FieldName>& geometry_fields() {
  static const std::string displacement = "displacement from the placed start", pattern = "place in the flat pattern";
  static const std::vector<FieldName> fields = {{"disp_x", "mm", displacement},
                                                {"disp_y", "mm", displacement},
                                                {"disp_z", "mm", displacement},
                                                {"pattern_x", "mm", pattern},
                                                {"pattern_y", "mm", pattern}};
  return fields;
}

}  // namespace toile::result
