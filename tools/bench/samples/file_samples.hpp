// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <iosfwd>

#include "geodrome/engine/pipeline.hpp"
#include "geodrome/engine/plugin_host.hpp"

namespace geodrome::bench {

/// Takes the vertices of each file as points and prints what stages 1 to 4 make of them: a surface or the refusal, time
/// and topology; where the file has faces, their topology, and the gap between the two surfaces, both ways, as shares
/// of the diagonal, from 200,000 seeded points of each. A file that cannot be read is told and passed over.
void print_file_samples(std::ostream& out, const std::vector<std::filesystem::path>& files, const PluginHost& host,
                        const RunSettings& settings);

}  // namespace geodrome::bench
