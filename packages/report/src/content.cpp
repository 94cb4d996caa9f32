#include "content.hpp"

#include <algorithm>
#include <cmath>

#include "base64.hpp"

namespace toile::report {
namespace {

using result::FieldValues;
using result::Results;
using result::ResultsBlock;

/// What a reader looks at first; all others follow in the order of the file.
const char* const first_fields[] = {"pressure", "pressure_error", "stretch_wale", "stretch_course", "wrinkle_state",
                                    "gap",      "cauchy_minor",   "body_error",   "tension_course", "tension_wale",
                                    "crossing", "extrapolated"};

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool is_component(const std::string& name) {
  return ends_with(name, "_x") || ends_with(name, "_y") || ends_with(name, "_z");
}

Json header(const FieldValues& field) {
  return {{"name", field.name.name}, {"unit", field.name.unit}};
}

bool shows(const std::vector<std::string>& shown, const FieldValues& field) {
  return std::find(shown.begin(), shown.end(), field.name.name) != shown.end();
}

/// Place in the order of what is wanted most.
std::ptrdiff_t place_of(const std::string& name) {
  return std::find(std::begin(first_fields), std::end(first_fields), name) - std::begin(first_fields);
}

/// A part of the nodes: x, y, z of each.
std::string positions(const Results& results, std::size_t begin, std::size_t end) {
  std::vector<double> all;
  for (std::size_t n = begin; n < end; ++n)
    for (const std::vector<double>& x : results.position) all.push_back(x[n]);
  return base64(all);
}

Json nodal_fields(const Results& results, const std::vector<std::string>& shown, std::size_t begin, std::size_t end) {
  Json fields = Json::array();
  for (const FieldValues& field : results.nodal) {
    if (!shows(shown, field)) continue;
    const std::vector<double> part(field.values.begin() + static_cast<std::ptrdiff_t>(begin),
                                   field.values.begin() + static_cast<std::ptrdiff_t>(end));
    // A field of the garment alone is zero on the body, and the other way round.
    if (std::all_of(part.begin(), part.end(), [](double v) { return v == 0.0; }) &&
        std::any_of(field.values.begin(), field.values.end(), [](double v) { return v != 0.0; }))
      continue;
    Json one = header(field);
    one["values"] = base64(part);
    fields.push_back(one);
  }
  return fields;
}

Json block_of(const ResultsBlock& block, const std::vector<std::string>& shown, int first_node) {
  std::vector<int> nodes = block.connectivity;
  for (int& node : nodes) node -= first_node;
  Json fields = Json::array();
  for (const FieldValues& field : block.fields) {
    if (!shows(shown, field)) continue;
    Json one = header(field);
    one["values"] = base64(field.values);
    fields.push_back(one);
  }
  return {{"name", block.name}, {"perElement", block.nodes_per_element}, {"nodes", base64(nodes)}, {"fields", fields}};
}

/// Garment or body: its part of the nodes, and the blocks on it.
Json surface(const Results& results, const std::vector<ResultsBlock>& blocks, const std::vector<std::string>& shown,
             std::size_t begin, std::size_t end) {
  Json all = {{"position", positions(results, begin, end)},
              {"fields", nodal_fields(results, shown, begin, end)},
              {"blocks", Json::array()}};
  for (const ResultsBlock& block : blocks) all["blocks"].push_back(block_of(block, shown, static_cast<int>(begin)));
  return all;
}

Json history(const Results& results) {
  Json fields = Json::array();
  for (const FieldValues& field : results.global) {
    Json one = header(field);
    one["values"] = field.values;  // not a number becomes null
    fields.push_back(one);
  }
  return fields;
}

}  // namespace

std::vector<std::string> shown_fields(const Results& results) {
  std::vector<std::string> names;
  const auto add = [&](const FieldValues& field) {
    if (!is_component(field.name.name) && !shows(names, field)) names.push_back(field.name.name);
  };
  for (const FieldValues& field : results.nodal) add(field);
  for (const ResultsBlock& block : results.garment)
    for (const FieldValues& field : block.fields) add(field);
  std::stable_sort(names.begin(), names.end(),
                   [](const std::string& a, const std::string& b) { return place_of(a) < place_of(b); });
  return names;
}

Json content_of(const Results& results, const std::vector<std::string>& fields) {
  const auto garment = static_cast<std::size_t>(results.garment_nodes), all = results.position.front().size();
  Json content;
  content["garment"] = surface(results, results.garment, fields, 0, garment);
  content["body"] = results.body.empty() ? Json() : surface(results, results.body, fields, garment, all);
  content["history"] = history(results);
  content["steps"] = results.steps;
  return content;
}

}  // namespace toile::report
