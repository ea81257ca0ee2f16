// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "geodrome/engine/input.hpp"
#include "geodrome/engine/outputs.hpp"

namespace geodrome {

/// The files that a run reads: its input, its weights and those that selections name as '@FILE'.
std::vector<std::filesystem::path> files_read(const std::filesystem::path& input, const ReadOptions& options,
                                              std::span<const std::string> selections);

/// Throws OptionError if a file's name, if there is one, has none of the endings.
void check_ending(const std::filesystem::path& file, std::initializer_list<const char*> endings);

/// Throws OptionError as `check_ending` for the name of a mesh, which must be .ply if it is read with weights.
void check_mesh_ending(const std::filesystem::path& file, const ReadOptions& options);

}  // namespace geodrome
