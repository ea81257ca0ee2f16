// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "geodrome/shortest_path_map.hpp"

namespace geodrome::test {

/// A shortest-path map with planted faults: every answer of a right one goes through a function first.
class FalsifiedMap : public ShortestPathMap {
 public:
  using ChangeDistance = std::function<Distance(const SurfacePoint&, Distance)>;
  using ChangePath = std::function<void(std::vector<SurfacePoint>&)>;

  explicit FalsifiedMap(const ShortestPathMap& right, ChangeDistance distance = {}, ChangePath path = {})
      : right_(right),
        vertices_(right.vertices().begin(), right.vertices().end()),
        change_distance_(std::move(distance)),
        change_path_(std::move(path)) {}

  /// Another list of the vertices' distances.
  FalsifiedMap(const ShortestPathMap& right, std::vector<double> vertices)
      : right_(right), vertices_(std::move(vertices)) {}

  std::span<const double> vertices() const override { return vertices_; }
  Distance at(const SurfacePoint& point) const override {
    const Distance right = right_.at(point);
    return change_distance_ ? change_distance_(point, right) : right;
  }
  void path(const SurfacePoint& point, std::vector<SurfacePoint>& out) const override {
    right_.path(point, out);
    if (change_path_) change_path_(out);
  }
  std::span<const Counter> counters() const override { return right_.counters(); }

 private:
  const ShortestPathMap& right_;
  std::vector<double> vertices_;
  ChangeDistance change_distance_;
  ChangePath change_path_;
};

}  // namespace geodrome::test
