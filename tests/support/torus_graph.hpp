// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <numeric>
#include <queue>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome::test {

/// Paths on the torus of `shapes::sample` along straight pieces in its angles, between the nodes of a lattice: upper
/// bounds of distances.
class TorusGraph {
 public:
  TorusGraph(long columns, long rows, long reach) : columns_(columns), rows_(rows) {
    for (long i = -reach; i <= reach; ++i)
      for (long j = -reach; j <= reach; ++j)
        if (std::gcd(std::abs(i), std::abs(j)) == 1) offsets_.push_back({i, j, lengths(i, j)});
  }

  std::size_t size() const { return static_cast<std::size_t>(columns_ * rows_); }
  Vec3 point(std::size_t node) const {
    const double u = angle(static_cast<long>(node) / rows_, columns_),
                 v = angle(static_cast<long>(node) % rows_, rows_);
    const double w = ring + tube * std::cos(v);
    return {w * std::cos(u), w * std::sin(u), tube * std::sin(v)};
  }

  /// Dijkstra's algorithm.
  std::vector<double> distances(std::size_t source) const {
    using Entry = std::pair<double, std::size_t>;
    std::vector<double> best(size(), std::numeric_limits<double>::infinity());
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    queue.push({best[source] = 0, source});
    while (!queue.empty()) {
      const auto [length, node] = queue.top();
      queue.pop();
      if (length > best[node]) continue;
      const long column = static_cast<long>(node) / rows_, row = static_cast<long>(node) % rows_;
      for (const Offset& o : offsets_) {
        const long c = (column + o.i + columns_) % columns_, r = (row + o.j + rows_) % rows_;
        const auto next = static_cast<std::size_t>(c * rows_ + r);
        const double reached = length + o.length_from_row[static_cast<std::size_t>(row)];
        if (reached < best[next]) queue.push({best[next] = reached, next});
      }
    }
    return best;
  }

 private:
  static constexpr double ring = 1, tube = 0.4;

  struct Offset {
    long i, j;
    std::vector<double> length_from_row;
  };

  static double angle(long i, long count) {
    return 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
  }

  /// Per starting row, a bound of the length of the straight piece: in each of 64 parts w is taken at its largest, at
  /// an end or (if the part passes v = 0) R + r.
  std::vector<double> lengths(long i, long j) const {
    constexpr int parts = 64;
    const double du = angle(i, columns_) / parts, dv = angle(j, rows_) / parts;
    std::vector<double> result;
    for (long row = 0; row < rows_; ++row) {
      double sum = 0;
      for (int k = 0; k < parts; ++k) {
        const double begin = angle(row, rows_) + k * dv, end = begin + dv;
        const bool passes_outside = std::sin(begin) * std::sin(end) <= 0 && std::cos(begin) > 0;
        const double cosine = passes_outside ? 1 : std::max(std::cos(begin), std::cos(end));
        sum += std::hypot((ring + tube * cosine) * du, tube * dv);
      }
      result.push_back(sum);
    }
    return result;
  }

  long columns_, rows_;
  std::vector<Offset> offsets_;
};

}  // namespace geodrome::test
