// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>

namespace geodrome {

/// Finds mistakes in the names of the files to be written that would otherwise show after all is computed; empty names
/// are left out. `read` are the files that are read. Throws InputError (io) for a folder that is missing or may not be
/// written and for what is no regular file, OptionError for a file that is also read or named twice, links and relative
/// names seen through.
void check_outputs(std::span<const std::filesystem::path> outputs, std::span<const std::filesystem::path> read);

}  // namespace geodrome
