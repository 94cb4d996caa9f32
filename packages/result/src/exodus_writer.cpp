#include "toile/result/exodus_writer.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "exodus_model.hpp"
#include "exodus_step.hpp"
#include "toile/base/error.hpp"

namespace toile::result {
namespace {

void check_names(const std::string& path, const char* kind, const Texts& names) {
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (name.size() > static_cast<std::size_t>(longest_name)) {
      throw base::InputError("Exodus file '" + path + "': the name of " + kind + " '" + name + "' has " +
                             std::to_string(name.size()) + " characters, at most " + std::to_string(longest_name) +
                             " are possible");
    }
    if (!seen.insert(name).second) {
      throw base::InputError("Exodus file '" + path + "': two " + kind + "s have the name '" + name + "'");
    }
  }
}

[[noreturn]] void fail(const std::string& name, const std::string& problem) {
  throw base::Error(base::ExitCode::internal_error, "field '" + name + "' of an Exodus step " + problem);
}

void check_size(const std::string& name, std::size_t found, int expected) {
  if (found != static_cast<std::size_t>(expected)) {
    fail(name, "has " + std::to_string(found) + " values instead of " + std::to_string(expected));
  }
}

const std::vector<double>& required(const Values& values, const std::string& name, int size) {
  const auto found = values.find(name);
  if (found == values.end()) {
    fail(name, "is missing");
  }
  check_size(name, found->second.size(), size);
  return found->second;
}

/// The values of a nodal field on garment or body, zero if it is not given there.
void append_or_zero(std::vector<double>& all, const Values& values, const std::string& name, int size) {
  if (values.count(name) == 0) {
    all.resize(all.size() + static_cast<std::size_t>(size), 0.0);
    return;
  }
  const std::vector<double>& part = required(values, name, size);
  all.insert(all.end(), part.begin(), part.end());
}

template <class Map>
void check_declared(const Map& given, const std::vector<FieldName>& declared) {
  for (const auto& [name, value] : given) {
    const auto same = [&key = name](const FieldName& field) { return field.name == key; };
    if (std::none_of(declared.begin(), declared.end(), same)) {
      fail(name, "was not declared");
    }
  }
}

}  // namespace

ExodusWriter::ExodusWriter(const std::string& path, const mesh::Mesh& garment, const body::TriangleMesh* body,
                           const FieldNames& fields)
    : path_(path), fields_(fields), garment_nodes_(garment.nodes()) {
  if (body != nullptr) {
    body_nodes_ = static_cast<int>(body->vertices.size());
    body_elements_ = static_cast<int>(body->triangles.size());
  }
  Texts edges;
  for (const auto& edge : garment.edges) {
    edges.push_back(edge.first);
  }
  check_names(path, "panel", block_names(garment, body));
  check_names(path, "edge", edges);
  check_names(path, "nodal field", nodal_names(fields));
  check_names(path, "element field", element_names(fields));
  check_names(path, "global field", names_of(fields.global));
  for (const mesh::Block& block : garment.blocks) {
    block_sizes_.push_back(block.size());
  }
  const auto nodes = static_cast<std::size_t>(garment_nodes_) + static_cast<std::size_t>(body_nodes_);
  pattern_x_.resize(nodes, 0.0);
  pattern_y_.resize(nodes, 0.0);
  for (std::size_t i = 0; i < garment.pattern.size(); ++i) {
    pattern_x_[i] = garment.pattern[i].x();
    pattern_y_[i] = garment.pattern[i].y();
  }
  new_file_ = std::make_unique<Replacement>(path, "cannot create the Exodus file '" + path + "': ");
  ExodusFile file = ExodusFile::create(new_file_->path());
  put_model(file, garment, body, fields);
  file.close();
}

void ExodusWriter::go_on(int steps) {
  keep_steps(path_, new_file_->path(), steps);
  new_file_.reset();
  steps_ = steps;
}

void ExodusWriter::check(const StepData& data) const {
  check_size("disp", data.displacement.size(), garment_nodes_);
  check_declared(data.nodal, fields_.nodal);
  check_declared(data.body_nodal, fields_.nodal);
  check_declared(data.element, fields_.element);
  check_declared(data.body_element, fields_.body_element);
  check_declared(data.global, fields_.global);
}

std::vector<std::vector<double>> ExodusWriter::nodal_variables(const StepData& data) const {
  std::vector<std::vector<double>> variables(3);
  for (int k = 0; k < 3; ++k) {
    for (const mesh::Vec3& displacement : data.displacement) {
      variables[static_cast<std::size_t>(k)].push_back(displacement[k]);
    }
    variables[static_cast<std::size_t>(k)].resize(pattern_x_.size(), 0.0);
  }
  variables.push_back(pattern_x_);
  variables.push_back(pattern_y_);
  for (const FieldName& field : fields_.nodal) {
    std::vector<double> values;
    append_or_zero(values, data.nodal, field.name, garment_nodes_);
    append_or_zero(values, data.body_nodal, field.name, body_nodes_);
    variables.push_back(std::move(values));
  }
  return variables;
}

std::vector<ExodusWriter::BlockVariable> ExodusWriter::block_variables(const StepData& data) const {
  std::vector<BlockVariable> variables;
  const int elements = std::accumulate(block_sizes_.begin(), block_sizes_.end(), 0);
  int index = 0;
  for (const FieldName& field : fields_.element) {
    auto from = required(data.element, field.name, elements).begin();
    ++index;
    for (std::size_t block = 0; block < block_sizes_.size(); ++block) {
      const auto to = from + block_sizes_[block];
      variables.push_back({index, static_cast<int>(block) + 1, {from, to}});
      from = to;
    }
  }
  for (const FieldName& field : fields_.body_element) {
    const int body_block = static_cast<int>(block_sizes_.size()) + 1;
    variables.push_back({++index, body_block, required(data.body_element, field.name, body_elements_)});
  }
  return variables;
}

std::vector<double> ExodusWriter::global_variables(const StepData& data) const {
  std::vector<double> values;
  for (const FieldName& field : fields_.global) {
    const auto found = data.global.find(field.name);
    if (found == data.global.end()) {
      fail(field.name, "is missing");
    }
    values.push_back(found->second);
  }
  return values;
}

void ExodusWriter::write_step(double time, const StepData& data) {
  // Everything is checked and laid out before the file is touched.
  check(data);
  const auto nodal = nodal_variables(data);
  const auto blocks = block_variables(data);
  const auto global = global_variables(data);
  const int step = steps_ + 1;
  ExodusStep file(path(), step);
  int index = 0;
  for (const auto& values : nodal) {
    file.put_nodal(++index, values);
  }
  for (const BlockVariable& variable : blocks) {
    file.put_block(variable.index, variable.block, variable.values);
  }
  file.put_global(global);
  file.finish(time);
  if (new_file_) {
    new_file_->take_place();
    new_file_.reset();
  }
  steps_ = step;
}

}  // namespace toile::result
