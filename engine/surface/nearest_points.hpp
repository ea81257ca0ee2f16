// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome {

/// Nearest points of a sample: an R-tree. Immutable; thread-safe.
class NearestPoints {
 public:
  /// O(n log n).
  explicit NearestPoints(std::span<const Vec3> points);
  ~NearestPoints();

  /// The `k` nearest points, or all if there are fewer, by distance and then index. O(k log n) typically.
  std::vector<Index> nearest(const Vec3& query, std::size_t k) const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace geodrome
