#include <algorithm>
#include <cmath>
#include <sstream>

#include "text.hpp"
#include "toile/base/reference.hpp"

namespace toile::base {
namespace {

/// One list of the input, or one variant of it.
struct Section {
  std::string title;
  Texts notes;
  std::vector<Parameter> parameters;
};

/// A free name stands in angle brackets.
void collect(const Spec& spec, const std::string& title, const Texts& notes, std::vector<Section>& sections) {
  sections.push_back({title, notes, spec.parameters()});
  for (const auto& [sub, is_required] : spec.lists()) {
    collect(sub, title + " > " + sub.name(), {sub.text(), is_required ? "Required." : "Optional."}, sections);
  }
  if (const auto& entry = spec.entry()) {
    const int least = spec.least_entries();
    const std::string number =
        least == 0 ? "Any number of lists" : "At least " + std::to_string(least) + (least == 1 ? " list" : " lists");
    collect(*entry, title + " > <" + entry->name() + ">", {entry->text(), number + " with names of your choice."},
            sections);
  }
  for (const auto& [selector, variants] : spec.variants())
    for (const Spec& variant : variants) {
      const std::string condition = selector + " = \"" + variant.name() + "\"";
      collect(variant, title + ", " + condition, {variant.text(), "In addition, if " + condition + "."}, sections);
    }
}

std::vector<Section> sections_of(const TitledSpec& part) {
  std::vector<Section> sections;
  collect(part.spec, part.title, {part.spec.text()}, sections);
  return sections;
}

std::string type_column(const Parameter& parameter) {
  return type_text(parameter.type) + (parameter.may_table ? " or table" : "");
}

std::string allowed_column(const Parameter& parameter) {
  return parameter.choices.empty() ? parameter.range.text() : join(parameter.choices, ", ");
}

std::string default_column(const Parameter& parameter) {
  if (std::holds_alternative<std::monostate>(parameter.fallback)) return "required";
  const auto* number = std::get_if<double>(&parameter.fallback);
  if (number != nullptr && !std::isfinite(*number)) return std::isnan(*number) ? "none" : "unbounded";
  return value_text(parameter.fallback);
}

Texts columns(const Parameter& parameter) {
  return {parameter.name, type_column(parameter), parameter.unit, allowed_column(parameter), default_column(parameter),
          parameter.text};
}

const Texts& headings() {
  static const Texts all = {"name", "type", "unit", "allowed", "default", "meaning"};
  return all;
}

constexpr const char* table_note =
    "A \"double or table\" is one number or a list of the parameter's name with two Array(double): \"position\" "
    "(relative, 0 at the lower end of the panel to 1 at the upper, strictly increasing) and \"value\"; "
    "linear in between.";

bool has_tables(const std::vector<Section>& sections) {
  return std::any_of(sections.begin(), sections.end(), [](const Section& section) {
    return std::any_of(section.parameters.begin(), section.parameters.end(),
                       [](const Parameter& one) { return one.may_table; });
  });
}

std::string escaped(const std::string& cell) {
  std::string text;
  for (const char c : cell) text += c == '|' ? std::string("\\|") : std::string(1, c);
  return text;
}

void print_row(std::ostream& out, const Texts& cells) {
  for (const std::string& cell : cells) out << "| " << escaped(cell) << ' ';
  out << "|\n";
}

void print_lines(std::ostream& out, const Parameter& parameter) {
  Texts facts = {type_column(parameter)};
  if (!parameter.unit.empty()) facts.push_back(parameter.unit);
  if (const std::string allowed = allowed_column(parameter); !allowed.empty()) facts.push_back("allowed: " + allowed);
  const std::string fallback = default_column(parameter);
  facts.push_back(fallback == "required" ? fallback : fallback == "none" ? "no default" : "default: " + fallback);
  out << "  " << parameter.name << "  [" << join(facts, "; ") << "]\n      " << parameter.text << '\n';
}

}  // namespace

std::string describe_markdown(const TitledSpec& part) {
  const std::vector<Section> sections = sections_of(part);
  std::ostringstream out;
  for (const Section& section : sections) {
    out << "## `" << section.title << "`\n\n" << join(section.notes, " ") << "\n\n";
    if (section.parameters.empty()) continue;
    print_row(out, headings());
    print_row(out, Texts(headings().size(), "---"));
    for (const Parameter& parameter : section.parameters) print_row(out, columns(parameter));
    out << '\n';
  }
  if (has_tables(sections)) out << table_note << '\n';
  return out.str();
}

std::string describe_text(const TitledSpec& part) {
  const std::vector<Section> sections = sections_of(part);
  std::ostringstream out;
  for (const Section& section : sections) {
    out << section.title << "\n  " << join(section.notes, " ") << '\n';
    for (const Parameter& parameter : section.parameters) print_lines(out, parameter);
    out << '\n';
  }
  if (has_tables(sections)) out << table_note << '\n';
  return out.str();
}

std::string describe_markdown(const Spec& spec) {
  return describe_markdown(TitledSpec{spec.name(), spec});
}

std::string describe_text(const Spec& spec) {
  return describe_text(TitledSpec{spec.name(), spec});
}

}  // namespace toile::base
