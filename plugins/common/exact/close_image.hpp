// SPDX-License-Identifier: MIT
#pragma once

#include "plugins/common/exact/ordered_pair.hpp"
#include "plugins/common/exact/tolerances.hpp"

namespace geodrome {

/// Tells whether an image is close to a half-edge, beside the part of it that its rays cross: they cross at nearly one
/// place, which rounding does not tell apart any more. Such rays go on at once and alone, so that they are not cut by
/// places on that half-edge. The image lies so on faces without area, and next to a vertex that nearly coincides with
/// an end of the half-edge.
template <class Image>
bool is_close(const Image& image, const Interval& crossed, double length) {
  const double close = close_share * length;
  return -image.y <= close && crossed.low - close < image.x && image.x < crossed.high + close;
}

}  // namespace geodrome
