// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

#include "engine/formats/source_file.hpp"

namespace geodrome::input {

inline constexpr std::string_view gzip_ending = ".gz";

/// The first bytes are those of gzip, whatever the name says.
bool is_gzip(std::string_view bytes);

/// The bytes that a packed file may hold: 100 times its own, at least 256 MB. Meshes and points pack to a third or a
/// tenth; what packs to less holds hardly anything but repetitions, and may be made to use up the memory.
constexpr std::size_t largest_unpacked(std::size_t packed) {
  constexpr std::size_t usual = 100, always = 256'000'000;
  return packed > always / usual ? packed * usual : always;
}

/// Replaces the bytes of a gzip file by what they hold, of all its members one after the other; zeros at the end are
/// passed over. Throws InputError: (truncated) if the file ends too early, (syntax) if it is damaged or goes on with
/// something else, (unsupported) if it holds more than `limit` bytes, before they are in memory, (empty) if it holds
/// none. Precondition: `is_gzip`.
void unpack_gzip(SourceFile& file, std::size_t limit);
inline void unpack_gzip(SourceFile& file) { unpack_gzip(file, largest_unpacked(file.bytes.size())); }

}  // namespace geodrome::input
