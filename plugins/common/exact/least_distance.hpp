// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

namespace geodrome {

/// Returns the least distance from an image to the points of an interval of the half-edge, with sigma: no point that a
/// line of the image through the interval reaches is nearer. `image` has x, y and sigma.
///
/// A list with a limit is judged by the least of this over its parts. The distances at its two outer ends say nothing
/// about what is between them: trimming leaves lines that are not shortest paths, and from such a part to its neighbour
/// the distance may fall by more than the way along the half-edge.
template <class Image>
double least_distance(const Image& image, double low, double high) {
  const double aside = std::max({low - image.x, 0.0, image.x - high});
  return image.sigma + std::sqrt(aside * aside + image.y * image.y);
}

}  // namespace geodrome
