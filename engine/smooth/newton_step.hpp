// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "geodrome/smooth_surface.hpp"

namespace geodrome {

/// Steps of Newton's method that make a curve shorter whose nodes move across it; its ends stay. Owns its buffers.
class NewtonStep {
 public:
  /// Finds how far each node is to move along its direction, the first and the last by 0. Returns false, with `moves`
  /// undefined, where the curve is no neighbour of a shortest one: the second derivative of its length is not positive.
  /// Precondition: nodes next to each other differ. O(nodes).
  bool find(std::span<const SmoothPoint> nodes, std::span<double> moves);

 private:
  std::vector<double> pivot_, right_, beside_;
};

}  // namespace geodrome
