#include <Tpetra_Core.hpp>
#include <iomanip>
#include <iostream>

#include "commands.hpp"
#include "toile/base/error.hpp"
#include "toile/result/field_name.hpp"
#include "toile/solve/output_fields.hpp"

namespace toile::app {

namespace {

using solve::FieldPlace;
using solve::OutputField;

std::string text_of(FieldPlace place) {
  if (place == FieldPlace::node) return "nodes";
  return place == FieldPlace::element ? "elements" : "global";
}

std::vector<OutputField> all_fields() {
  std::vector<OutputField> all;
  for (const result::FieldName& field : result::geometry_fields())
    all.push_back({FieldPlace::node, field.name, field.unit, field.text});
  const result::FieldName& error = result::body_error_field();
  all.push_back({FieldPlace::node, error.name, error.unit, error.text});
  const std::vector<OutputField> computed = solve::output_fields();
  all.insert(all.end(), computed.begin(), computed.end());
  return all;
}

/// Fields that are told in one line, for instance the components of a vector.
struct Line {
  OutputField field;
  std::vector<std::string> names;
};

std::vector<Line> lines() {
  std::vector<Line> all;
  for (const OutputField& field : all_fields()) {
    if (all.empty() || all.back().field.text != field.text || all.back().field.place != field.place)
      all.push_back({field, {}});
    all.back().names.push_back(field.name);
  }
  return all;
}

void print_markdown(std::ostream& out) {
  out << "| on | field | unit | meaning |\n|---|---|---|---|\n";
  for (const Line& line : lines()) {
    out << "| " << text_of(line.field.place) << " | ";
    for (const std::string& name : line.names) out << (&name == &line.names.front() ? "`" : ", `") << name << "`";
    out << " | " << line.field.unit << " | " << line.field.text << " |\n";
  }
}

void print_text(std::ostream& out) {
  out << "Fields of results.exo; the global ones are also in history.h5.\n";
  for (const Line& line : lines()) {
    out << "  " << std::left << std::setw(9) << text_of(line.field.place);
    for (const std::string& name : line.names) out << (&name == &line.names.front() ? "" : ", ") << name;
    out << (line.field.unit.empty() ? "" : " [" + line.field.unit + "]") << ": " << line.field.text << "\n";
  }
}

}  // namespace

int describe_fields(bool markdown) {
  if (Tpetra::getDefaultComm()->getRank() != 0) return static_cast<int>(base::ExitCode::success);
  if (markdown)
    print_markdown(std::cout);
  else
    print_text(std::cout);
  return static_cast<int>(base::ExitCode::success);
}

}  // namespace toile::app
