#pragma once

#include <string>
#include <vector>

#include "toile/solve/fields.hpp"

namespace toile::solve {

/// Where a field has its values.
enum class FieldPlace { node, element, global };

/// A field that a run may write, as users read of it. All of them are declared in three tables: nodal and global ones
/// in output_fields.cpp, those of elements in element_fields.cpp.
struct OutputField {
  FieldPlace place = FieldPlace::node;
  std::string name;
  std::string unit;  ///< empty: dimensionless
  std::string text;  ///< Markdown
};

/// Every field that there is, in the order of the tables; a vector is one entry per component.
std::vector<OutputField> output_fields();

/// The fields of one state, a value a node: those of contact only if `problem` has a body.
std::vector<NamedField> nodal_fields(const Problem& problem, const Fields& fields);
/// A value an element, all blocks one after another: those of wrinkles only if a material of `problem` relaxes.
std::vector<NamedField> element_fields(const Fields& fields);
/// Names of the global fields that a support has.
std::vector<std::string> field_names_of(const Support& support);
/// One value each.
std::vector<NamedField> global_fields(const Problem& problem, const StepReport& report);

/// The one of these fields that has this name; an internal error if there is none.
const NamedField& named(const std::vector<NamedField>& fields, const std::string& name);
/// By value from fields that end with the expression.
NamedField named(std::vector<NamedField>&& fields, const std::string& name);

}  // namespace toile::solve
