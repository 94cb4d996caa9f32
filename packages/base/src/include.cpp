#include "include.hpp"

#include <Teuchos_Array.hpp>
#include <algorithm>
#include <filesystem>

#include "toile/base/error.hpp"
#include "toile/base/file.hpp"
#include "validate.hpp"
#include "xml_reader.hpp"

namespace toile::base {
namespace {

using Teuchos::ParameterList;

const std::string include_key = "include";
const std::string replace_key = "replace";
const std::string remove_key = "remove";
/// A file that includes the next one twice, and so on, would else be read millions of times.
constexpr int most_files = 200;

std::string below(const std::string& path, const std::string& name) {
  return path + " > " + name;
}

bool is_true(const ParameterList& list, const std::string& key) {
  return list.isType<bool>(key) && list.get<bool>(key);
}

/// Files that are being read, outermost first: what includes itself would never end.
using Chain = std::vector<std::filesystem::path>;

class Reader {
 public:
  /// `file`: the one that the others are included in.
  Reader(const std::string& file, const std::string& root) : root_(root), merged_{ParameterList(root), Origins(file)} {}

  void read(const std::string& file) { read(file, merged_.list, {}); }
  void read(const Content& content) { add(content.list, content.name, merged_.list, {}); }
  Merged take() { return std::move(merged_); }

 private:
  /// Puts what `file` says, and before it what it includes, on top of `list`.
  void read(const std::string& file, ParameterList& list, Chain chain) {
    const ParameterList own = parse_xml(content_of(file), file, root_);
    chain.push_back(std::filesystem::weakly_canonical(file));
    add(own, file, list, chain);
  }

  void add(const ParameterList& own, const std::string& file, ParameterList& list, const Chain& chain) {
    if (own.isType<Teuchos::Array<std::string>>(include_key)) {
      for (const std::string& name : own.get<Teuchos::Array<std::string>>(include_key)) {
        const std::string path = (std::filesystem::path(file).parent_path() / name).lexically_normal().string();
        check_included(file, name, path, chain);
        read(path, list, chain);
      }
    }
    overlay(list, own, root_, file);
  }

  std::string content_of(const std::string& file) {
    if (++files_ > most_files)
      throw InputError(file + ": more than " + std::to_string(most_files) +
                       " files are included, counted each time that they are");
    std::string content = read_file(file, "an XML file", most_input);
    size_ += content.size();
    if (size_ > most_input)
      throw InputError(file + ": with the files before it, more than the " + std::to_string(most_input >> 20U) +
                       " MB that are allowed");
    return content;
  }

  void check_included(const std::string& file, const std::string& name, const std::string& path, const Chain& chain) {
    const std::string where = problem_line(file, root_, "parameter \"include\" names \"" + name + "\"");
    if (const std::string why = unreadable(path); !why.empty())
      throw InputError(where + ", but of the file " + path + ": " + why);
    if (std::find(chain.begin(), chain.end(), std::filesystem::weakly_canonical(path)) != chain.end()) {
      throw InputError(where + ", which includes this file again");
    }
  }

  void overlay(ParameterList& list, const ParameterList& own, const std::string& path, const std::string& file) {
    merged_.origins.note(path, file);
    for (auto item = own.begin(); item != own.end(); ++item) {
      const std::string& name = own.name(item);
      if (own.entry(item).isList()) {
        overlay_list(list, name, own.sublist(name), below(path, name), file);
      } else if ((name == replace_key || name == remove_key) && own.isType<bool>(name) && path != root_) {
        continue;  // of the list itself, see overlay_list()
      } else {
        if (list.isSublist(name)) list.remove(name);
        list.setEntry(name, own.entry(item));
        merged_.origins.note(below(path, name), file);
      }
    }
  }

  void overlay_list(ParameterList& list, const std::string& name, const ParameterList& own, const std::string& path,
                    const std::string& file) {
    const bool replaces = is_true(own, replace_key), removes = is_true(own, remove_key);
    if ((replaces || removes) && !list.isSublist(name)) {
      throw InputError(problem_line(
          file, path,
          "parameter \"" + (removes ? remove_key : replace_key) + "\" is true, but no included file has this list"));
    }
    if (removes && own.numParams() > 1) {
      throw InputError(problem_line(file, path,
                                    "parameter \"remove\" is true, but the list has more in it: \"replace\" takes the "
                                    "place of the included list"));
    }
    if (replaces || removes || (list.isParameter(name) && !list.isSublist(name))) list.remove(name);
    if (removes) return;
    overlay(list.sublist(name), own, path, file);
  }

  std::string root_;
  Merged merged_;
  int files_ = 0;
  std::size_t size_ = 0;  ///< of all of them, bytes
};

}  // namespace

Parameter include_parameter() {
  return {
      include_key, Type::texts, "",
      "Files (paths from the folder of this one) whose lists are read first, so that a variant of a scene holds only "
      "its difference. What this file says goes before what it includes, a later file before an earlier one. A list "
      "with the parameter \"replace\" = true takes the place of the included list of its name; one with \"remove\" = "
      "true takes that list out.",
      Texts{}};
}

Merged read_merged(const std::string& file, const std::string& root) {
  Reader reader(file, root);
  reader.read(file);
  return reader.take();
}

Merged merged(const Content& content, const std::string& root) {
  Reader reader(content.name, root);
  reader.read(content);
  return reader.take();
}

}  // namespace toile::base
