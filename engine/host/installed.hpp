// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/engine/installed.hpp"

/// Finds what is installed beside the engine from the place of the engine's library, so that an install can be moved.
namespace geodrome {

/// The folder of the engine's library.
std::filesystem::path engine_folder();

/// A program that works on the engine's behalf. Throws PluginError, naming the places searched, if it is missing.
std::filesystem::path installed_program(const std::string& name);

}  // namespace geodrome
