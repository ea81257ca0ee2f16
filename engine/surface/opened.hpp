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

}  // namespace geodrome
