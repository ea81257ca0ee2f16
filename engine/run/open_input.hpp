// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/engine/pipeline.hpp"

namespace geodrome {

/// Input and surface, which every job starts with.
struct Opened {
  Input input;
  Surface surface;
  double read_seconds = 0, surface_seconds = 0;
};

/// Reads and checks the file, runs stages 1 to 4, and tells the observer what was found on the way (of a
/// mesh: warnings only).
Opened open_input(const std::filesystem::path& file, const PluginHost& host, const RunSettings& settings,
                  Observer& observer);

}  // namespace geodrome
