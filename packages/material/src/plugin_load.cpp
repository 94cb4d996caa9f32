#include <dlfcn.h>

#include <filesystem>

#include "toile/base/error.hpp"
#include "toile/base/file.hpp"
#include "toile/material/plugin.hpp"
#include "toile/material/plugin_files.hpp"
#include "toolchain.hpp"

namespace toile::material {
namespace {

namespace fs = std::filesystem;

std::string difference(const std::string& what, const std::string& found, const std::string& own) {
  return found == own ? "" : "; its " + what + " is " + found + ", that of this Toile is " + own;
}

/// What differs between the stamp of a plug-in and that of this program; empty: nothing.
std::string differences(const Stamp& stamp) {
  return difference("interface", std::to_string(stamp.abi), std::to_string(material_abi)) +
         difference("version", stamp.version, toolchain().version) +
         difference("number of lanes", std::to_string(stamp.lanes), std::to_string(lanes)) +
         difference("compiler", stamp.compiler, __VERSION__);
}

}  // namespace

std::string plugin_path(const base::List& entry) {
  return (fs::path(entry.file("file")).parent_path() / entry.word("file")).lexically_normal().string();
}

Laws::Law load_plugin(const std::string& library) {
  if (!fs::exists(library))
    throw base::InputError(library + ": there is no such plug-in; toile material build makes one from a C++ file");
  base::require_file(library, "a plug-in");
  // An absolute path, because the loader would look for a bare name in the system's folders.
  void* handle = dlopen(fs::absolute(library).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr)
    throw base::InputError(library + ": this is not a shared library that can be loaded: " + dlerror());
  const std::shared_ptr<void> loaded(handle, [](void* open) { dlclose(open); });
  const auto* plugin = static_cast<const PlugIn*>(dlsym(handle, "toile_material"));
  if (plugin == nullptr)
    throw base::InputError(library +
                           ": this library holds no fabric (no symbol toile_material); end its C++ file with "
                           "TOILE_MATERIAL(...) and build it with toile material build");
  const std::string different = differences(plugin->stamp);
  if (!different.empty())
    throw base::InputError(library + ": this plug-in was built for another Toile" + different +
                           ". Build it again with toile material build");
  return {loaded, &plugin->law};
}

base::Spec plugins_spec() {
  base::Spec entry("law", "One fabric, by the name of its law.");
  entry.word("file", "Shared library from toile material build, from the folder of this file.");
  return base::Spec("Plug-ins",
                    "Fabrics that are compiled to plug-ins, by the name of their law, which a material names as its "
                    "\"type\". They are programs, so they are loaded only with --allow-plugins.")
      .entries(entry);
}

void add_plugins(const base::List& list, bool allowed, Laws& laws) {
  for (const base::List& entry : list.entries()) {
    const std::string library = plugin_path(entry);
    if (!allowed)
      entry.fail("file", "this would run the program in " + fs::absolute(library).string() +
                             ". If you trust it, allow that with the option --allow-plugins");
    Laws::Law law;
    try {
      law = load_plugin(library);
    } catch (const base::InputError& error) {
      entry.fail("file", error.what());
    }
    if (entry.name() != law->name)
      entry.fail("file", std::string("the law in this plug-in is named \"") + law->name + "\"; name the list so");
    if (!laws.add(law))
      entry.fail("file", std::string("there is a law named \"") + law->name +
                             "\" already; give the one in the plug-in another name");
  }
}

}  // namespace toile::material
