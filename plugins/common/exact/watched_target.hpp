// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "geodrome/surface.hpp"

namespace geodrome {

/// A point in a face whose distance is lowered while windows pass over it.
struct Watched {
  SurfacePoint at;  ///< with the face's number in the flat surface
  double distance = std::numeric_limits<double>::infinity();
  Index source = no_index;
};

}  // namespace geodrome
