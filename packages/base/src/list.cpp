#include <cmath>

#include "list_data.hpp"
#include "text.hpp"
#include "toile/base/error.hpp"

namespace toile::base {
namespace {

template <class T>
const T& get(const List::Data& data, const std::string& name) {
  const auto found = data.values.find(name);
  const T* value = found == data.values.end() ? nullptr : std::get_if<T>(&found->second);
  if (value == nullptr) {
    throw Error(ExitCode::internal_error,
                "parameter '" + name + "' is read in '" + data.path + "' but not declared there with this type");
  }
  return *value;
}

/// A default that only says that there is none; a value that is given is finite.
bool is_no_number(const Value& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr && !std::isfinite(*number);
}

/// A value of a length that a message can hold.
std::string shown(const std::string& text) {
  constexpr std::size_t most = 500;
  return text.size() > most ? text.substr(0, most) + "..." : text;
}

}  // namespace

double List::real(const std::string& name) const {
  return get<double>(*data_, name);
}

int List::integer(const std::string& name) const {
  return get<int>(*data_, name);
}

bool List::flag(const std::string& name) const {
  return get<bool>(*data_, name);
}

const std::string& List::word(const std::string& name) const {
  return get<std::string>(*data_, name);
}

const Reals& List::reals(const std::string& name) const {
  return get<Reals>(*data_, name);
}

const Texts& List::words(const std::string& name) const {
  return get<Texts>(*data_, name);
}

bool List::has_list(const std::string& name) const {
  return data_->lists.count(name) > 0;
}

List List::list(const std::string& name) const {
  const auto found = data_->lists.find(name);
  if (found == data_->lists.end()) {
    throw Error(ExitCode::internal_error, "list '" + name + "' is read in '" + data_->path + "' but is not there");
  }
  return List(found->second);
}

std::vector<List> List::entries() const {
  std::vector<List> all;
  all.reserve(data_->entries.size());
  for (const auto& entry : data_->entries) all.emplace_back(entry);
  return all;
}

bool List::has_table(const std::string& name) const {
  return data_->tables.count(name) > 0;
}

std::vector<std::pair<double, double>> List::table(const std::string& name) const {
  const auto found = data_->tables.find(name);
  if (found == data_->tables.end()) {
    throw Error(ExitCode::internal_error, "'" + name + "' is read as a table in '" + data_->path + "' but is none");
  }
  return found->second;
}

bool List::given(const std::string& name) const {
  return data_->given.count(name) > 0;
}

const std::string& List::name() const {
  return data_->name;
}

std::string List::path() const {
  return data_->path;
}

const std::string& List::file() const {
  return data_->file;
}

const std::string& List::file(const std::string& parameter) const {
  const auto found = data_->given.find(parameter);
  return found == data_->given.end() ? data_->file : found->second;
}

void List::fail(const std::string& parameter, const std::string& problem) const {
  std::string found;
  const auto value = data_->values.find(parameter);
  if (has_table(parameter)) {
    found = " = table";
  } else if (value != data_->values.end() && is_no_number(value->second)) {
    found = " (not given)";
  } else if (value != data_->values.end()) {
    found = " = " + shown(value_text(value->second)) + (given(parameter) ? "" : " (default)");
  }
  throw InputError(file(parameter) + ": " + data_->path + ": parameter \"" + parameter + "\"" + found + ": " + problem);
}

}  // namespace toile::base
