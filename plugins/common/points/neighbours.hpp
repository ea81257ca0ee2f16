// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <memory>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome {

/// A point found near another; orders by distance, then by index.
struct Neighbour {
  double squared_distance = 0;
  Index index = no_index;

  friend auto operator<=>(const Neighbour&, const Neighbour&) = default;
};

/// Searches neighbours among fixed points exactly, by a kd-tree of FLANN (`KDTreeSingleIndex`) without its traps:
/// results are complete, in double precision, sorted by distance and then index, and do not depend on the shape of the
/// tree.
///
/// Every search replaces `out` and leaves out the point `without`, where one is given. Immutable; thread-safe.
class Neighbours {
 public:
  /// Builds the tree. Points should be distinct; there may be none. Throws SampleError, naming the point, for a
  /// coordinate that is not finite, and for more than 2^31 - 1 points. O(n log n); about 70 bytes a point.
  explicit Neighbours(std::vector<Vec3> points);
  ~Neighbours();
  Neighbours(Neighbours&&) noexcept;
  Neighbours& operator=(Neighbours&&) noexcept;

  std::size_t size() const noexcept;
  const std::vector<Vec3>& points() const noexcept;

  /// Finds the `k` nearest points, or all points if there are fewer. A longer search begins with the results of a
  /// shorter one, so that going through neighbours in increasing distance is: search, use, double k. O(k log n)
  /// typically.
  void nearest(const Vec3& query, std::size_t k, std::vector<Neighbour>& out, Index without = no_index) const;

  /// Finds the `k` nearest points and all that are as far as the last of them, to a relative 1e-9: unlike the `k`
  /// nearest, this set does not depend on the order of the points, nor on rounding where points lie on a lattice.
  void nearest_and_ties(const Vec3& query, std::size_t k, std::vector<Neighbour>& out, Index without = no_index) const;

  /// Finds the points of the closed ball: `distance(query, point) <= radius` as geometry.hpp computes it.
  void within(const Vec3& query, double radius, std::vector<Neighbour>& out, Index without = no_index) const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace geodrome
