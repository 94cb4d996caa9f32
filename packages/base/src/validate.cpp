#include "validate.hpp"

#include <Teuchos_Array.hpp>
#include <algorithm>
#include <functional>

#include "list_data.hpp"
#include "scope.hpp"
#include "text.hpp"
#include "toile/base/error.hpp"

namespace toile::base {
namespace {

/// More are of one cause.
constexpr std::size_t most_problems = 50;

using Teuchos::ParameterEntry;
using Teuchos::ParameterList;

/// The value of an entry, or std::monostate if its type is none that Toile reads.
Value value_of(const ParameterEntry& entry) {
  const auto& any = entry.getAny(false);
  if (any.type() == typeid(double)) return Teuchos::any_cast<double>(any);
  if (any.type() == typeid(int)) return Teuchos::any_cast<int>(any);
  if (any.type() == typeid(bool)) return Teuchos::any_cast<bool>(any);
  if (any.type() == typeid(std::string)) return Teuchos::any_cast<std::string>(any);
  if (any.type() == typeid(Teuchos::Array<double>)) return Teuchos::any_cast<Teuchos::Array<double>>(any).toVector();
  if (any.type() == typeid(Teuchos::Array<int>)) {
    const auto& whole = Teuchos::any_cast<Teuchos::Array<int>>(any);
    return Reals(whole.begin(), whole.end());
  }
  if (any.type() == typeid(Teuchos::Array<std::string>)) {
    return Teuchos::any_cast<Teuchos::Array<std::string>>(any).toVector();
  }
  return {};
}

std::string found_text(const ParameterEntry& entry, const Value& value) {
  static const Texts names = {"", "double", "int", "bool", "string", "Array(double)", "Array(string)"};
  if (entry.isList()) return "a list";
  if (value.index() == 0) return "a value of type " + entry.getAny(false).typeName();
  return value_text(value) + " (" + names[value.index()] + ")";
}

bool has_type(const Value& value, Type type) {
  static const std::vector<Type> types = {Type::real, Type::real,  Type::integer, Type::flag,
                                          Type::text, Type::reals, Type::texts};
  return value.index() > 0 && types[value.index()] == type;
}

/// Validates one list of the input against its description.
class Validator {
 public:
  Validator(const ParameterList& list, const Spec& spec, const Origins& origins, std::string path, std::string name,
            Texts& problems)
      : list_(list), scope_(spec, list), origins_(origins), problems_(problems), data_(std::make_shared<List::Data>()) {
    data_->file = origins.of(path);
    data_->path = std::move(path);
    data_->name = std::move(name);
  }

  std::shared_ptr<const List::Data> run() {
    for (const Parameter* parameter : scope_.parameters) read_parameter(*parameter);
    for (auto item = list_.begin(); item != list_.end(); ++item) {
      const std::string& name = list_.name(item);
      if (scope_.parameter(name) != nullptr) continue;
      if (list_.entry(item).isList()) {
        read_list(name);
      } else {
        unknown_parameter(name);
      }
    }
    for (const auto* sub : scope_.lists) {
      if (sub->second && !list_.isSublist(sub->first.name())) {
        problem("missing list \"" + sub->first.name() + "\": " + sub->first.text());
      }
    }
    const int found = static_cast<int>(data_->entries.size());
    if (scope_.complete && found < scope_.least_entries) {
      problem("has " + std::to_string(found) + " entries, needs at least " + std::to_string(scope_.least_entries) +
              ". An entry is a list with a name of your choice: " + scope_.entry->text());
    }
    return data_;
  }

 private:
  void problem(const std::string& text) { problems_.push_back(problem_line(data_->file, data_->path, text)); }
  /// A problem with what is given as `name`, which another file may have written than the list around it.
  void problem_with(const std::string& name, const std::string& text) {
    problems_.push_back(problem_line(file_of(name), data_->path, text));
  }
  const std::string& file_of(const std::string& name) const { return origins_.of(data_->path + " > " + name); }

  void read_parameter(const Parameter& parameter) {
    data_->values[parameter.name] = parameter.fallback;
    const ParameterEntry* entry = list_.getEntryPtr(parameter.name);
    if (entry == nullptr) {
      if (std::holds_alternative<std::monostate>(parameter.fallback)) {
        problem("missing parameter \"" + parameter.name + "\", expected " + expected_text(parameter) + ": " +
                parameter.text);
      }
      return;
    }
    data_->given[parameter.name] = file_of(parameter.name);
    if (entry->isList() && parameter.may_table) {
      data_->values.erase(parameter.name);
      read_table(parameter);
      return;
    }
    Value value = value_of(*entry);
    const int* whole = std::get_if<int>(&value);
    if (parameter.type == Type::real && whole != nullptr) value = static_cast<double>(*whole);
    if (!has_type(value, parameter.type)) {
      problem_with(parameter.name, "parameter \"" + parameter.name + "\" is " + found_text(*entry, value) +
                                       ", expected " + expected_text(parameter));
      return;
    }
    check_value(parameter, value);
    data_->values[parameter.name] = std::move(value);
  }

  static std::string expected_text(const Parameter& parameter) {
    return type_text(parameter.type) + (parameter.unit.empty() ? "" : " in " + parameter.unit) +
           (parameter.may_table ? " or a list with \"position\" and \"value\"" : "");
  }

  void check_value(const Parameter& parameter, const Value& value) {
    if (const auto* number = std::get_if<double>(&value)) check_range(parameter, *number, "");
    if (const auto* number = std::get_if<int>(&value)) check_range(parameter, *number, "");
    if (const auto* numbers = std::get_if<Reals>(&value)) {
      for (std::size_t i = 0; i < numbers->size(); ++i) {
        check_range(parameter, (*numbers)[i], ", value number " + std::to_string(i + 1) + ",");
      }
    }
    if (const auto* word = std::get_if<std::string>(&value)) {
      const Texts& choices = parameter.choices;
      if (!choices.empty() && std::find(choices.begin(), choices.end(), *word) == choices.end()) {
        problem_with(parameter.name, "parameter \"" + parameter.name + "\" has the unknown value \"" + *word + "\"" +
                                         hint(*word, choices));
      }
    }
  }

  void check_range(const Parameter& parameter, double number, const std::string& which) {
    if (number - number != 0.0) {
      problem_with(parameter.name, "parameter \"" + parameter.name + "\"" + which + " is " + number_text(number) +
                                       ", not a finite number");
    } else if (!parameter.range.contains(number)) {
      const std::string unit = parameter.unit.empty() ? "" : " " + parameter.unit;
      problem_with(parameter.name, "parameter \"" + parameter.name + "\"" + which + " is out of range: " +
                                       number_text(number) + unit + ", allowed: " + parameter.range.text() + unit);
    }
  }

  void read_table(const Parameter& parameter) {
    Spec spec(parameter.name, parameter.text);
    spec.reals("position", "", "Relative positions along the panel, strictly increasing.", required,
               Range::between(0.0, 1.0));
    spec.reals("value", parameter.unit, "The values there.", required, parameter.range);
    const std::size_t before = problems_.size();
    const auto table = sub(parameter.name, spec);
    if (problems_.size() > before) return;
    const auto& position = std::get<Reals>(table->values.at("position"));
    const auto& value = std::get<Reals>(table->values.at("value"));
    const std::string where = "table \"" + parameter.name + "\": ";
    if (position.empty() || position.size() != value.size()) {
      problem_with(parameter.name, where + "\"position\" has " + std::to_string(position.size()) +
                                       " numbers and \"value\" has " + std::to_string(value.size()) +
                                       "; both need the same number of them, at least one");
      return;
    }
    if (std::adjacent_find(position.begin(), position.end(), std::greater_equal<>()) != position.end()) {
      problem_with(parameter.name, where + "\"position\" is " + value_text(position) + "; it must increase strictly");
      return;
    }
    auto& rows = data_->tables[parameter.name];
    for (std::size_t i = 0; i < position.size(); ++i) rows.emplace_back(position[i], value[i]);
  }

  std::shared_ptr<const List::Data> sub(const std::string& name, const Spec& spec) {
    return Validator(list_.sublist(name), spec, origins_, data_->path + " > " + name, name, problems_).run();
  }

  void read_list(const std::string& name) {
    if (const Spec* fixed = scope_.list(name)) {
      data_->lists[name] = sub(name, *fixed);
    } else if (scope_.entry != nullptr) {
      data_->entries.push_back(sub(name, *scope_.entry));
    } else if (scope_.complete) {
      problem_with(name, "unknown list \"" + name + "\"" + scope_.belongs(name) + hint(name, scope_.list_names()));
    }
  }

  void unknown_parameter(const std::string& name) {
    if (scope_.list(name) != nullptr) {
      problem_with(name, "\"" + name + "\" is a parameter here, expected a list: " + scope_.list(name)->text());
    } else if (scope_.complete || scope_.belongs(name).empty()) {
      problem_with(name,
                   "unknown parameter \"" + name + "\"" + scope_.belongs(name) + hint(name, scope_.parameter_names()));
    }
  }

  const ParameterList& list_;
  Scope scope_;
  const Origins& origins_;
  Texts& problems_;
  std::shared_ptr<List::Data> data_;
};

}  // namespace

std::string problem_line(const std::string& file, const std::string& path, const std::string& problem) {
  return file + ": " + path + ": " + problem;
}

std::shared_ptr<const List::Data> validated(const ParameterList& list, const Spec& spec, const Origins& origins,
                                            Texts& problems) {
  return Validator(list, spec, origins, spec.name(), spec.name(), problems).run();
}

void throw_if_any(const Texts& problems) {
  if (problems.empty()) return;
  const auto shown = problems.begin() + static_cast<long>(std::min(problems.size(), most_problems));
  std::string text = join(Texts(problems.begin(), shown), "\n");
  if (problems.size() > most_problems) text += "\nand " + std::to_string(problems.size() - most_problems) + " more";
  throw InputError(text);
}

List validate(const ParameterList& list, const Spec& spec, const Origins& origins) {
  Texts problems;
  auto data = validated(list, spec, origins, problems);
  throw_if_any(problems);
  return List(std::move(data));
}

List validate(const ParameterList& list, const Spec& spec, const std::string& file) {
  Origins origins(file);
  if (!spec.completion()) return validate(list, spec, origins);
  ParameterList completed(list);
  spec.completion()(completed, origins);
  return validate(completed, spec, origins);
}

}  // namespace toile::base
