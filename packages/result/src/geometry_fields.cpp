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

const FieldName& body_error_field() {
  static const FieldName field = {
      "body_error", "mm",
      "only on the nodes of a body from a file: how far the smooth surface that the fabric "
      "lies on is outside of the file's vertices, linear in between; 0 as well where there is none"};
  return field;
}

}  // namespace toile::result
