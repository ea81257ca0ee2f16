// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace geodrome {

/// A file or folder of data that is installed beside the engine: "templates/solver" (a project for a plugin),
/// "compare.html" (the page of a comparison). Found from where the engine's library lies, so that an install can be
/// moved. Throws PluginError, naming the places searched, if it is missing. Thread-safe.
std::filesystem::path installed_data(const std::string& name);

}  // namespace geodrome
