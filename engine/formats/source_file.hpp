// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geodrome/errors.hpp"

namespace geodrome::input {

/// A file held in memory, read once, so that nothing is ever reserved on the word of a header.
struct SourceFile {
  std::filesystem::path path;
  std::string bytes;      ///< unpacked
  bool unpacked = false;  ///< the file is gzip-compressed
};

/// Reads a whole file, and unpacks it if it is gzip (gzip.hpp). Throws InputError (io) for what is missing, no file or
/// unreadable, (empty) for 0 bytes.
SourceFile read_source(const std::filesystem::path& path);

/// XXH3, 128 bits, as 32 hexadecimal digits.
std::string content_hash(std::string_view bytes);

/// Throws InputError with a message that starts with the file's name.
[[noreturn]] void reject(const SourceFile& file, InputFault fault, const std::string& what, Remedy remedy = {});

/// Text of a file as it may be shown in a message: short, in one line, printable.
std::string quoted(std::string_view text);

}  // namespace geodrome::input
