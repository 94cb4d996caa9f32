#include "include.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_FileInputSource.hpp>
#include <Teuchos_XMLParameterListReader.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "toile/base/error.hpp"
#include "validate.hpp"
#include "xml_check.hpp"

namespace toile::base {
namespace {

using Teuchos::ParameterList;

const std::string include_key = "include";
const std::string replace_key = "replace";

std::string below(const std::string& path, const std::string& name) {
  return path + " > " + name;
}

ParameterList read_one(const std::string& file, const std::string& root) {
  if (std::filesystem::is_directory(file)) throw InputError(file + ": this is a folder, expected an XML file");
  if (!std::ifstream(file).good()) throw InputError(file + ": cannot open this file");
  Teuchos::XMLObject xml;
  try {
    xml = Teuchos::FileInputSource(file).getObject();
  } catch (const std::exception& error) {
    throw InputError(file + ": not well-formed XML: " + xml_reason(error.what()));
  }
  Texts problems;
  check_xml(xml, root, file, problems);
  throw_if_any(problems);
  try {
    return Teuchos::XMLParameterListReader().toParameterList(xml);
  } catch (const std::exception& error) {
    throw InputError(file + ": not a Teuchos parameter list: " + xml_reason(error.what()));
  }
}

/// Files that are being read, outermost first: what includes itself would never end.
using Chain = std::vector<std::filesystem::path>;

class Reader {
 public:
  Reader(const std::string& file, const std::string& root) : root_(root), merged_{ParameterList(root), Origins(file)} {
    read(file, merged_.list, {});
  }
  Merged take() { return std::move(merged_); }

 private:
  /// Puts what `file` says, and before it what it includes, on top of `list`.
  void read(const std::string& file, ParameterList& list, Chain chain) {
    ParameterList own = read_one(file, root_);
    chain.push_back(std::filesystem::weakly_canonical(file));
    if (own.isType<Teuchos::Array<std::string>>(include_key)) {
      for (const std::string& name : own.get<Teuchos::Array<std::string>>(include_key)) {
        const std::string path = (std::filesystem::path(file).parent_path() / name).lexically_normal().string();
        check_included(file, name, path, chain);
        read(path, list, chain);
      }
    }
    overlay(list, own, root_, file);
  }

  void check_included(const std::string& file, const std::string& name, const std::string& path, const Chain& chain) {
    const std::string where = problem_line(file, root_, "parameter \"include\" names \"" + name + "\"");
    if (!std::ifstream(path).good()) throw InputError(where + ", but the file " + path + " cannot be opened");
    if (std::find(chain.begin(), chain.end(), std::filesystem::weakly_canonical(path)) != chain.end()) {
      throw InputError(where + ", which includes this file again");
    }
  }

  void overlay(ParameterList& list, const ParameterList& own, const std::string& path, const std::string& file) {
    merged_.origins.note(path, file);
    for (auto item = own.begin(); item != own.end(); ++item) {
      const std::string& name = own.name(item);
      if (own.entry(item).isList()) {
        overlay_list(list, own.sublist(name), below(path, name), file);
      } else {
        if (list.isSublist(name)) list.remove(name);
        list.setEntry(name, own.entry(item));
        merged_.origins.note(below(path, name), file);
      }
    }
  }

  void overlay_list(ParameterList& list, ParameterList own, const std::string& path, const std::string& file) {
    const std::string name = path.substr(path.rfind(" > ") + 3);
    const bool replaces = own.isType<bool>(replace_key) && own.get<bool>(replace_key);
    if (replaces && !list.isSublist(name)) {
      throw InputError(problem_line(file, path, "parameter \"replace\" is true, but no included file has this list"));
    }
    own.remove(replace_key, false);
    if (replaces || (list.isParameter(name) && !list.isSublist(name))) list.remove(name);
    overlay(list.sublist(name), own, path, file);
  }

  std::string root_;
  Merged merged_;
};

}  // namespace

Parameter include_parameter() {
  return {
      include_key, Type::texts, "",
      "Files (paths from the folder of this one) whose lists are read first, so that a variant of a scene holds only "
      "its difference. What this file says goes before what it includes, a later file before an earlier one. A list "
      "with the parameter \"replace\" = true takes the place of the included list of its name.",
      Texts{}};
}

Merged read_merged(const std::string& file, const std::string& root) {
  return Reader(file, root).take();
}

}  // namespace toile::base
