// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <variant>

#include "engine/host/child.hpp"
#include "geodrome/engine/plugin_info.hpp"

namespace geodrome {

/// Loads `file` in a child process (`geodrome-vet`) and tells what it is, or why it is refused. Throws PluginError if
/// the vetting itself cannot be done, OptionError if GEODROME_VET_TIMEOUT is no positive number of seconds.
std::variant<PluginInfo, PluginRefusal> vet(const std::filesystem::path& file);

/// Takes the answer of `geodrome-vet` on `file`, which exited, apart. Throws PluginError if it is one of another
/// version, nlohmann's exceptions if it is no answer.
std::variant<PluginInfo, PluginRefusal> read_answer(const std::filesystem::path& file, const ChildEnd& end);

}  // namespace geodrome
