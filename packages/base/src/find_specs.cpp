#include <algorithm>
#include <regex>
#include <set>

#include "text.hpp"
#include "toile/base/error.hpp"
#include "toile/base/reference.hpp"

namespace toile::base {
namespace {

const std::string separator = " > ";

Texts names_in(const std::string& path) {
  Texts names;
  std::size_t begin = 0;
  for (std::size_t end = path.find('>'); end != std::string::npos; end = path.find('>', begin)) {
    names.push_back(trimmed(path.substr(begin, end - begin)));
    begin = end + 1;
  }
  names.push_back(trimmed(path.substr(begin)));
  return names;
}

class Finder {
 public:
  explicit Finder(Texts names) : names_(std::move(names)) {}

  /// Looks for the names from `next` on in `spec`, which `title` leads to.
  void find(const Spec& spec, const std::string& title, std::size_t next) {
    if (next == names_.size()) {
      found_.push_back({title, spec});
      return;
    }
    const std::string& name = names_[next];
    const std::string below = title.empty() ? "" : title + separator;
    bool here = false;
    for (const auto& [list, is_required] : spec.lists()) {
      note(list.name(), next);
      if (list.name() != name) continue;
      find(list, below + name, next + 1);
      here = true;
    }
    for (const Parameter& parameter : spec.parameters()) {
      note(parameter.name, next);
      if (parameter.name != name) continue;
      found_.push_back({title.empty() ? spec.name() : title, Spec(spec.name(), spec.text()).add(parameter)});
      here = true;
    }
    for (const auto& [selector, variants] : spec.variants())
      for (const Spec& variant : variants)
        find(variant, title + ", " + selector + " = \"" + variant.name() + "\"", next);
    if (!here && spec.entry()) find(*spec.entry(), below + "<" + spec.entry()->name() + ">", next + 1);
  }

  std::vector<TitledSpec> take(const std::string& path) {
    if (found_.empty())
      throw InputError("\"" + path + "\": there is no list or parameter \"" + names_[deepest_] + "\"" +
                       hint(names_[deepest_], Texts(valid_.begin(), valid_.end())));
    return std::move(found_);
  }

 private:
  /// A name that is valid as number `place` of the path.
  void note(const std::string& name, std::size_t place) {
    if (place < deepest_) return;
    if (place > deepest_) valid_.clear();
    deepest_ = place;
    valid_.insert(name);
  }

  Texts names_;
  std::vector<TitledSpec> found_;
  std::size_t deepest_ = 0;
  std::set<std::string> valid_;
};

}  // namespace

std::vector<TitledSpec> find_specs(const Spec& root, const std::string& path) {
  Texts names = names_in(path);
  const bool from_root = names.front() == root.name();
  if (from_root) names.erase(names.begin());
  if (names.empty()) return {{root.name(), root}};
  Finder finder(std::move(names));
  finder.find(root, from_root ? root.name() : "", 0);
  return finder.take(path);
}

std::string path_in(const std::string& message) {
  std::smatch found;
  if (!std::regex_search(message, found,
                         std::regex("(?:^|: )([^:]*? > [^:]*?): (?:missing )?(?:parameter|list) \"([^\"]*)\"")) &&
      !std::regex_search(message, found, std::regex(": ([^:]*? > [^:]*?):")))
    return message;
  return found.str(1) + (found.size() > 2 ? separator + found.str(2) : "");
}

}  // namespace toile::base
