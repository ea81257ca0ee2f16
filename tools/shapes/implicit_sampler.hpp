// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "tools/shapes/implicit.hpp"
#include "tools/shapes/random.hpp"
#include "tools/shapes/voxels.hpp"

namespace geodrome::shapes {

/// Draws independent points of an implicit surface, exactly uniform by area.
///
/// The lines parallel to the three axes, equally dense, meet an area element dA with normal n in proportion to
/// (|n_x| + |n_y| + |n_z|) dA. So a random piece of such a line in a random cell near the surface is drawn, one of its
/// at most two meeting points is chosen or none, and it is kept with probability 1 / (|n_x| + |n_y| + |n_z|).
class ImplicitSampler {
 public:
  explicit ImplicitSampler(const Implicit& surface);

  const Implicit& surface() const { return surface_; }
  Vec3 draw(Random& random) const;

 private:
  const Implicit& surface_;
  VoxelGrid grid_;
  std::vector<Cell> cells_;
};

}  // namespace geodrome::shapes
