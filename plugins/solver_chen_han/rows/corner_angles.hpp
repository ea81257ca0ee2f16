// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/common/mesh/labels.hpp"
#include "plugins/solver_chen_han/rows/bearing.hpp"

namespace geodrome::chen_han {

/// The angles of all corners, and the directions at a vertex counted over all its faces: from 0 at its first corner to
/// the total angle, counterclockwise. Directions at vertices that are irregular, or that have more than
/// `largest_angle`, are not told. Immutable. 16 bytes a corner, 8 a vertex.
class CornerAngles {
 public:
  /// O(F).
  explicit CornerAngles(const PackedMesh& surface);

  /// Whether directions at a vertex are told.
  bool has_directions(Index vertex) const { return total_[vertex] > 0; }
  /// Returns the angle around a vertex. Precondition: `has_directions`.
  double total(Index vertex) const { return total_[vertex]; }
  /// Returns the angle of a corner.
  Bearing angle(Index corner) const { return angle_[corner]; }
  /// Returns the direction of the half-edge at which a corner starts; 0 where directions are not told.
  Bearing start(Index corner) const { return start_[corner]; }
  /// Returns the direction at an angle counterclockwise from a half-edge. Precondition: `has_directions` of its start.
  double direction(Index corner, Angle side) const;

  std::size_t bytes() const {
    return (angle_.size() + start_.size()) * sizeof(Bearing) + total_.size() * sizeof(double);
  }

 private:
  std::vector<Bearing> angle_, start_;
  std::vector<double> total_;
};

}  // namespace geodrome::chen_han
