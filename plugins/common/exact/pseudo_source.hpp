// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/geometry.hpp"

namespace geodrome {

/// A pseudo-source in the frame of a half-edge: in its face, or unfolded below it. A point p that a straight line from
/// it reaches is at distance sigma + |p - (x, y)|.
struct PseudoSource {
  double x, y, sigma;
  Index origin;  ///< a vertex, or `vertex count + i` for source i of the request
};

}  // namespace geodrome
