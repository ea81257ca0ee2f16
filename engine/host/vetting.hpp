// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <variant>

#include "geodrome/engine/plugin_info.hpp"

namespace geodrome {

/// Loads `file` in a child process (`geodrome-vet`) and tells what it is, or why it is refused. Throws PluginError if
/// the vetting itself cannot be done, OptionError if GEODROME_VET_TIMEOUT is no positive number of seconds.
std::variant<PluginInfo, PluginRefusal> vet(const std::filesystem::path& file);

}  // namespace geodrome
