// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace geodrome {

/// Writes a whole file, or nothing: to a temporary file beside it, FILE.PROCESS-N.tmp, that takes its name once it is
/// on the disk. Throws InputError (io) with the system's reason; the file that was there is then as it was, and no
/// other is left.
void write_atomically(const std::filesystem::path& file, std::string_view bytes);

}  // namespace geodrome
