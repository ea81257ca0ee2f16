// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "engine/formats/text_stream.hpp"
#include "geodrome/engine/plugin_info.hpp"
#include "geodrome/surface.hpp"

/// The file in which a solver's pair oracle is kept, little-endian:
///
///     preamble   64 bytes: magic, format version, lengths and XXH3 checksums of identity and payload, and its own
///     identity   JSON: what the oracle belongs to
///     payload    what the plugin saved, up to the end of the file
namespace geodrome {

/// The identity of an oracle's index. Two runs may share an index exactly if their identities are equal.
struct IndexIdentity {
  std::string solver;                          ///< "solver_aleksandrov"
  std::map<std::string, std::string> options;  ///< all of them; numbers in their shortest text, so that 0.10 is 0.1
  std::uint64_t seed = 0;
  std::uint64_t vertices = 0, faces = 0;
  std::string mesh;  ///< hash of positions, triangles and face weights: 32 hexadecimal digits
};

/// O(V + F).
IndexIdentity identity_of(const SurfaceMesh& mesh, const PluginInfo& plugin, const OptionValues& options,
                          std::uint64_t seed);

/// Saves what `save` writes: whole, or not at all. Returns the size of the file in bytes. Throws InputError (io), and
/// what `save` throws. Memory: the payload.
std::uint64_t write_index(const std::filesystem::path& file, const IndexIdentity& identity,
                          const std::function<void(std::ostream&)>& save);

/// The content of a file that is whole and belongs to `identity`, at the first byte of its payload, which ends it.
/// Throws InputError that names the file: (io) it cannot be read, (truncated), (syntax) no index, or damaged,
/// (unsupported) another format version, or made by another solver, with other options, for another mesh: the message
/// names what differs, with both values. O(bytes) in time and memory: what was checked is what is read.
TextInput open_index(const std::filesystem::path& file, const IndexIdentity& identity);

}  // namespace geodrome
