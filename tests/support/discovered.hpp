// SPDX-License-Identifier: MIT
#pragma once

#include <dlfcn.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "geodrome/abi.hpp"

namespace geodrome::test {

/// A plugin of this build, made with its default options.
template <class Stage>
struct Discovered {
  std::shared_ptr<const Stage> object;
  std::string name;
  Needs needs = Needs::nothing;
  Provides provides = Provides::nothing;
  double factor = 0;

  bool has(Provides bits) const { return geodrome::has(provides, bits); }
  friend std::ostream& operator<<(std::ostream& out, const Discovered& plugin) { return out << plugin.name; }
};

/// The plugin of a file, made with `options` as a user would write them; nothing if it is of another stage. Opens the
/// file itself, so that a fault of the plugin host is no fault of a plugin. Never closes it.
template <class Stage>
std::optional<Discovered<Stage>> discovered_in(const std::filesystem::path& file,
                                               std::string (*options_of)(const std::string& name) = nullptr) {
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) throw std::runtime_error(dlerror());
  const auto entry_point = reinterpret_cast<PluginEntry>(dlsym(library, plugin_entry));
  if (!entry_point) throw std::runtime_error(file.string() + " has no entry");
  const PluginDescriptor& plugin = *entry_point();
  if (std::strcmp(plugin.stage, Stage::stage) != 0) return std::nullopt;
  const OptionValues options({plugin.options, plugin.option_count}, options_of ? options_of(plugin.name) : "");
  const ErrorSink errors{nullptr, [](void*, bool, const char*) noexcept {}};
  auto* object = static_cast<Stage*>(plugin.create(&options, &errors));
  if (!object) throw std::runtime_error(file.string() + " cannot be made");
  return Discovered<Stage>{std::shared_ptr<const Stage>(object, plugin.destroy), plugin.name, plugin.needs,
                           plugin.provides, plugin.factor(&options)};
}

/// Every plugin of a stage that this build made, by name. `options_of` gives the options of a plugin by its name.
template <class Stage>
std::vector<Discovered<Stage>> discovered(std::string (*options_of)(const std::string& name) = nullptr) {
  std::vector<Discovered<Stage>> plugins;
  for (const auto& entry : std::filesystem::directory_iterator(GEODROME_BINARY_DIR "/lib/geodrome")) {
    if (entry.path().extension() != ".so") continue;
    if (auto plugin = discovered_in<Stage>(entry.path(), options_of)) plugins.push_back(std::move(*plugin));
  }
  std::sort(plugins.begin(), plugins.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return plugins;
}

}  // namespace geodrome::test
