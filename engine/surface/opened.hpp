// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/engine/pipeline.hpp"

namespace geodrome {

/// Input and surface, which every job starts with.
struct Opened {
  Input input;
  PlacedSurface surface;
  std::optional<SampleError> refusal;  ///< then `surface` has no mesh: see SurfaceAttempt
  double read_seconds = 0, surface_seconds = 0;
};

/// Reads and checks the file, and tells the observer what was found (of a mesh: warnings only).
Input read_and_tell(const std::filesystem::path& file, const RunSettings& settings, Observer& observer);

/// Reads and checks the file, runs stages 1 to 4, and tells the observer what was found on the way (of a
/// mesh: warnings only).
Opened try_open(const std::filesystem::path& file, const PluginHost& host, const RunSettings& settings,
                Observer& observer);

/// If the sample was refused: tells the observer the worst places, then throws the refusal.
void throw_if_refused(const Opened& opened, const RunSettings& settings, Observer& observer);

/// Both, for jobs without a report of their own: the observer is told the sample report in short.
Opened open_input(const std::filesystem::path& file, const PluginHost& host, const RunSettings& settings,
                  Observer& observer);

}  // namespace geodrome
