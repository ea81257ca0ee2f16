// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace geodrome {

/// Writes a whole file, or nothing: to a temporary file beside it that then takes its name. Throws InputError (io) with
/// the system's reason; the file that was there is then as it was.
void write_atomically(const std::filesystem::path& file, std::string_view bytes);

}  // namespace geodrome
