#include "toile/base/variant.hpp"

#include <Teuchos_Array.hpp>
#include <filesystem>

#include "include.hpp"
#include "scope.hpp"
#include "text.hpp"
#include "toile/base/error.hpp"
#include "toile/base/file.hpp"
#include "xml_value.hpp"

namespace toile::base {

namespace {

namespace fs = std::filesystem;
using Teuchos::ParameterList;

constexpr const char* included = "include";
constexpr std::size_t most_included_bytes = 512U << 20U;  ///< of a file that an input names

Merged whole(const ParameterList& content, const Spec& spec) {
  Merged all = merged({content, ""}, spec.name());
  if (spec.completion()) spec.completion()(all.list, all.origins);
  return all;
}

/// "Panels/front/size" or "Panels > front > size".
Texts names_of(const std::string& path) {
  Texts names(1);
  for (const char c : path) {
    if (c == '/' || c == '>')
      names.emplace_back();
    else
      names.back() += c;
  }
  for (std::string& name : names) name = trimmed(name);
  return names;
}

Texts lists_in(const ParameterList& list) {
  Texts names;
  for (auto item = list.begin(); item != list.end(); ++item)
    if (list.entry(item).isList()) names.push_back(list.name(item));
  return names;
}

/// As the XML file has the value: an array in braces.
std::string written(const Parameter& parameter, const std::string& text) {
  if (parameter.type != Type::reals && parameter.type != Type::texts) return text;
  std::string entries;
  bool apart = false;
  for (const char c : trimmed(text)) {
    const bool separates = c == ';' || (c == ' ' && parameter.type == Type::reals);
    if (!separates) entries += (apart ? ", " : "") + std::string(1, c);
    apart = separates || (apart && c == ' ');
  }
  return "{" + entries + "}";
}

[[noreturn]] void fail(const std::string& path, const std::string& problem) {
  throw InputError("path \"" + path + "\": " + problem);
}

}  // namespace

Variant::Variant(const Texts& files, const std::string& root) : content_(root) {
  Teuchos::Array<std::string> paths;
  for (const std::string& file : files) paths.push_back(fs::absolute(file).lexically_normal().string());
  content_.set(included, paths);
}

void Variant::set(const Spec& spec, const std::string& path, const std::string& text) {
  if (whole_.numParams() == 0) whole_ = whole(content_, spec).list;
  ParameterList* there = &whole_;
  const Spec* described = &spec;
  ParameterList* changed = &content_;
  const Texts names = names_of(path);
  for (std::size_t i = 0; i + 1 < names.size(); ++i) {
    const Scope scope(*described, *there);
    const Spec* fixed = scope.list(names[i]);
    const bool present = there->isSublist(names[i]);
    if (fixed == nullptr && (scope.entry == nullptr || !present)) {
      Texts valid = scope.list_names();
      if (scope.entry != nullptr) valid = lists_in(*there);
      fail(path, "there is no list \"" + names[i] + "\"" + scope.belongs(names[i]) + hint(names[i], valid));
    }
    described = fixed != nullptr ? fixed : scope.entry;
    there = &there->sublist(names[i]);
    changed = &changed->sublist(names[i]);
  }
  const Scope scope(*described, *there);
  const Parameter* parameter = scope.parameter(names.back());
  if (parameter == nullptr)
    fail(path, "there is no parameter \"" + names.back() + "\"" + scope.belongs(names.back()) +
                   hint(names.back(), scope.parameter_names()));
  for (ParameterList* list : {changed, there}) {
    if (list->isSublist(names.back())) list->remove(names.back());  // a table
    const std::string problem = set_value(*list, names.back(), type_text(parameter->type), written(*parameter, text));
    if (!problem.empty()) fail(path, "the value" + problem);
  }
}

std::string Variant::xml(const std::string& folder) const {
  ParameterList list = content_;
  Teuchos::Array<std::string> paths;
  for (const std::string& file : content_.get<Teuchos::Array<std::string>>(included))
    paths.push_back(fs::proximate(file, folder).string());
  list.set(included, paths);
  return xml_of(list);
}

namespace {

/// The files that texts of the list name.
void add_files(const ParameterList& list, const std::string& path, const Origins& origins, std::string& text) {
  for (auto item = list.begin(); item != list.end(); ++item) {
    const std::string below = path + " > " + list.name(item);
    if (list.entry(item).isList()) {
      add_files(list.sublist(list.name(item)), below, origins, text);
    } else if (list.entry(item).isType<std::string>() && list.name(item) == "file") {
      const std::string file =
          (fs::path(origins.of(below)).parent_path() / Teuchos::getValue<std::string>(list.entry(item))).string();
      if (!unreadable(file).empty()) continue;
      const std::string bytes = read_file(file, "a file", most_included_bytes);
      text += below + " " + std::to_string(bytes.size()) + " " + std::to_string(std::hash<std::string>()(bytes)) + "\n";
    }
  }
}

}  // namespace

std::string Variant::identity(const Spec& spec) const {
  const Merged all = merged({content_, ""}, spec.name());
  ParameterList list = all.list;
  list.remove(included, false);
  std::string text = xml_of(list);
  add_files(all.list, spec.name(), all.origins, text);
  return text;
}

}  // namespace toile::base
