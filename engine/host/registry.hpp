// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "geodrome/abi.hpp"
#include "geodrome/engine/plugin_info.hpp"

namespace geodrome {

/// A plugin that is loaded into this process, for good.
struct LoadedPlugin {
  PluginInfo info;
  PluginDescriptor descriptor;  ///< a copy: the members that an older plugin does not have are null
};

/// The plugin of `file` if it is loaded already, otherwise null. Thread-safe.
const LoadedPlugin* find_loaded(const std::filesystem::path& file);

/// Loads a plugin that was vetted as `info`. A library is never unloaded: its code may be on some thread's stack, in a
/// vtable or in a static destructor. Throws PluginError if it cannot be loaded. Thread-safe.
const LoadedPlugin& load_for_good(const PluginInfo& info);

}  // namespace geodrome
