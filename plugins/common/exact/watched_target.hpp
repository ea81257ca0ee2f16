// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/surface.hpp"

namespace geodrome {

/// A point in a face whose distance is lowered while wavefronts pass over it.
struct Watched {
  SurfacePoint at;  ///< with the face's number in the flat surface
  double distance = infinity;
  Index source = no_index;
};

}  // namespace geodrome
