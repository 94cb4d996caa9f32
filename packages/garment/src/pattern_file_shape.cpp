#include <filesystem>

#include "pattern_file.hpp"
#include "shape.hpp"
#include "toile/base/error.hpp"
#include "toile/pattern/file.hpp"

namespace toile::garment {
namespace {

base::Spec pattern_file_spec() {
  return base::Spec("pattern file", "A panel of a file of patterns, with its holes, lines and notches.")
      .word("file", pattern_file_text())
      .word("panel", "Name of the panel in the file; empty: that of the entry.", std::string());
}

Cut read_panel(const base::List& list) {
  const std::string name = list.word("panel").empty() ? list.name() : list.word("panel");
  const pattern::Pattern pattern = read_pattern_file(list);
  base::Texts valid;
  for (const pattern::Panel& panel : pattern.panels) {
    if (panel.name == name) return {panel, {}};
    valid.push_back(panel.name);
  }
  list.fail(list.given("panel") ? "panel" : "file",
            "the file \"" + path_of_pattern(list) + "\" has no panel \"" + name + "\"" + base::hint(name, valid));
}

}  // namespace

std::string pattern_file_text() {
  std::string formats;
  for (const std::string& format : pattern::formats()) formats += (formats.empty() ? "" : ", ") + format;
  return "The file, from the folder of the scene: " + formats + ".";
}

std::string path_of_pattern(const base::List& list) {
  const std::filesystem::path folder = std::filesystem::path(list.file("file")).parent_path();
  return (folder / list.word("file")).lexically_normal().string();
}

pattern::Pattern read_pattern_file(const base::List& list) {
  try {
    return pattern::read_pattern(path_of_pattern(list));
  } catch (const base::InputError& error) {
    list.fail("file", error.what());
  }
}

Shape pattern_file_shape() {
  return {pattern_file_spec(), read_panel, true};
}

}  // namespace toile::garment
