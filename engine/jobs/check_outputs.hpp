// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "geodrome/engine/formats.hpp"
#include "geodrome/engine/input.hpp"
#include "geodrome/engine/outputs.hpp"

namespace geodrome {

/// The files that a run reads: its input, its weights and those that selections name as '@FILE'.
std::vector<std::filesystem::path> files_read(const std::filesystem::path& input, const ReadOptions& options,
                                              std::span<const std::string> selections);

/// Throws OptionError if a file's name, if there is one, tells no format in which such a content is written.
void check_ending(const std::filesystem::path& file, Content content);

/// Throws OptionError as `check_ending` for the name of a mesh, whose format must hold weights if it is read with some.
void check_mesh_ending(const std::filesystem::path& file, const ReadOptions& options,
                       ScalarType scalar = ScalarType::float64);

}  // namespace geodrome
