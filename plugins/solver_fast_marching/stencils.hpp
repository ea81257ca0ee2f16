// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geodrome/solver_kit/packed_mesh.hpp"

namespace geodrome {

/// What a vertex A offers the third corner of a triangle, alone and together with the second corner B. The triangle is
/// a face, or a part of an unfolded strip of faces (splitting.hpp). Lengths are those of the flat surface.
struct Stencil {
  Index target;   ///< the third corner C
  Index partner;  ///< B
  double length;  ///< |AC|
  double base;    ///< |AB|
  double along;   ///< the foot of C on the line AB, from A to B, over |AB|; 0 if that is 0
  double across;  ///< the height of C over that line, over |AB|; 0 if that is 0
};

/// The stencils of every vertex of a flat surface: all triangles in which the front passes over one corner last,
/// obtuse ones split where the surface has a vertex to split them with. In flat arrays, immutable.
class Stencils {
 public:
  /// O(F), and at most `most_unfolded` faces for each obtuse corner.
  explicit Stencils(const PackedMesh& surface);

  std::span<const Stencil> of(Index vertex) const {
    return {stencils_.data() + first_[vertex], stencils_.data() + first_[vertex + 1]};
  }
  std::size_t bytes() const { return stencils_.size() * sizeof(Stencil) + first_.size() * sizeof(first_[0]); }

 private:
  std::vector<std::size_t> first_;
  std::vector<Stencil> stencils_;
};

}  // namespace geodrome
