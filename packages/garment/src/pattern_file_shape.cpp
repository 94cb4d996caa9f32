#include <algorithm>
#include <filesystem>

#include "shape.hpp"
#include "toile/base/error.hpp"
#include "toile/pattern/file.hpp"

namespace toile::garment {
namespace {

base::Spec pattern_file_spec() {
  std::string formats;
  for (const std::string& format : pattern::formats()) formats += (formats.empty() ? "" : ", ") + format;
  return base::Spec("pattern file", "A panel of a file of patterns, with its holes, lines and notches.")
      .word("file", "The file, from the folder of the scene: " + formats + ".")
      .word("panel", "Name of the panel in the file; empty: that of the entry.", std::string());
}

Cut read_panel(const base::List& list) {
  const std::filesystem::path folder = std::filesystem::path(list.file("file")).parent_path();
  const std::string file = (folder / list.word("file")).lexically_normal().string();
  const std::string name = list.word("panel").empty() ? list.name() : list.word("panel");
  pattern::Pattern pattern;
  try {
    pattern = pattern::read_pattern(file);
  } catch (const base::InputError& error) {
    list.fail("file", error.what());
  }
  base::Texts valid;
  for (const pattern::Panel& panel : pattern.panels) {
    if (panel.name == name) return {panel, {}};
    valid.push_back(panel.name);
  }
  list.fail(list.given("panel") ? "panel" : "file",
            "the file \"" + file + "\" has no panel \"" + name + "\"" + base::hint(name, valid));
}

}  // namespace

Shape pattern_file_shape() {
  return {pattern_file_spec(), read_panel, true};
}

}  // namespace toile::garment
