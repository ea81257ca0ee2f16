// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "geodrome/abi.hpp"
#include "geodrome/engine/boundary.hpp"
#include "geodrome/engine/plugin_info.hpp"

namespace geodrome {

/// The plugins that a search found: the usable ones by stage and name, and the refused files with the reason.
struct PluginListing {
  std::vector<PluginInfo> usable;
  std::vector<PluginRefusal> refused;
};

/// A loaded plugin with its options: the stage object, what it is, what was chosen. Copies share the object.
template <class Stage>
struct Plugin {
  std::shared_ptr<const Stage> object;
  PluginInfo info;
  OptionValues options;
  double factor = 0;  ///< the guarantee with these options; +inf for none; meaningless for stages other than solver
  const void* (*find_extension)(const char* id) noexcept = nullptr;  ///< of the descriptor; null: there are none

  /// Calls `function(object)` so that whatever leaves it names the plugin: see `boundary.hpp`.
  template <class Function>
  decltype(auto) call(Function&& function) const {
    return cross_boundary(info, [&]() -> decltype(auto) { return function(*object); });
  }

  /// The plugin's table of functions of an extension, found by `Extension::id`; null if the plugin has none. What the
  /// functions do must be called through `call`. The table stays for the life of the process. Thread-safe.
  template <class Extension>
  const Extension* extension() const {
    if (find_extension == nullptr) return nullptr;
    return cross_boundary(info, [&] { return static_cast<const Extension*>(find_extension(Extension::id)); });
  }
};

/// Finds, vets, loads and lists plugins. A library, once loaded, stays for the life of the process. Thread-safe.
///
/// Search order: `extra_folders`, GEODROME_PLUGIN_PATH (colon-separated), the folder `geodrome` beside the engine
/// library; never the working directory. The first file called <stage>_<name>.so that offers that stage and name wins;
/// where there is none, the first file of any name that does, in the order of folders and then of file names.
class PluginHost {
 public:
  /// Throws OptionError for an extra folder that is not there.
  explicit PluginHost(std::vector<std::filesystem::path> extra_folders = {});

  /// The folders that are searched, in the order of the search.
  const std::vector<std::filesystem::path>& folders() const noexcept { return folders_; }

  /// Vets every file (*.so) of every folder in a child process each, at most 10 s (GEODROME_VET_TIMEOUT: another number
  /// of seconds); survives whatever they do. `usable` is sorted by stage and name; a file whose offer is hidden by one
  /// that goes before it is among the refused. Throws PluginError if the program geodrome-vet is missing.
  PluginListing list() const;

  /// Vets one file as `list` does. Throws PluginError with the reason if it is refused, OptionError if it is not there.
  PluginInfo inspect(const std::filesystem::path& file) const;

  /// Finds the plugins that a user means by "cgal", "solver_cgal" or the path of a file (which holds a '/'): the file,
  /// or all plugins of that name, whatever their stage. Vets as `list` and `inspect` do. Throws OptionError for an
  /// unknown name, with those that there are; else as `inspect`.
  std::vector<PluginInfo> named(const std::string& name) const;

  /// Loads the plugin of a stage. `selection` is "name[:key=value,...]"; the name may carry its stage ("solver_cgal"),
  /// or be the path of a file. Throws OptionError for an unknown name (with the valid ones and the folders searched) or
  /// an option that is wrong, PluginError for a plugin that cannot be used (with file and reason).
  template <class Stage>
  Plugin<Stage> load(std::string_view selection) const {
    Loaded loaded = load_object(Stage::stage, selection);
    return {std::static_pointer_cast<const Stage>(std::move(loaded.object)), std::move(loaded.info),
            std::move(loaded.options), loaded.factor, loaded.find_extension};
  }

 private:
  struct Loaded {
    std::shared_ptr<const void> object;
    PluginInfo info;
    OptionValues options;
    double factor;
    const void* (*find_extension)(const char* id) noexcept;
  };
  Loaded load_object(std::string_view stage, std::string_view selection) const;
  PluginInfo find(std::string_view stage, const std::string& name) const;
  PluginInfo known_or_inspected(const std::filesystem::path& file) const;

  std::vector<std::filesystem::path> folders_;
};

}  // namespace geodrome
