// SPDX-License-Identifier: MIT
#include "tools/shapes/blue_noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <queue>

namespace geodrome::shapes {
namespace {

/// Points sorted into cubes of a given side, to find all neighbours within that distance.
class Buckets {
 public:
  Buckets(std::span<const Vec3> points, double side) : points_(points), side_(side) {
    for (Index i = 0; i < points.size(); ++i) entries_.push_back({cube(points[i]), i});
    std::sort(entries_.begin(), entries_.end());
  }

  template <class Visit>
  void neighbours(Index centre, Visit visit) const {
    const Cube around = cube(points_[centre]);
    for (long dx = -1; dx <= 1; ++dx)
      for (long dy = -1; dy <= 1; ++dy) {
        const Cube row{around[0] + dx, around[1] + dy, around[2] - 1}, end{row[0], row[1], around[2] + 2};
        for (auto e = std::lower_bound(entries_.begin(), entries_.end(), Entry{row, 0});
             e != entries_.end() && e->first < end; ++e) {
          const double gap = distance(points_[centre], points_[e->second]);
          if (e->second != centre && gap < side_) visit(e->second, gap);
        }
      }
  }

 private:
  using Cube = std::array<long, 3>;
  using Entry = std::pair<Cube, Index>;

  Cube cube(const Vec3& p) const {
    const auto slot = [&](double x) { return static_cast<long>(std::floor(x / side_)); };
    return {slot(p.x), slot(p.y), slot(p.z)};
  }

  std::span<const Vec3> points_;
  double side_;
  std::vector<Entry> entries_;
};

/// How much a neighbour at distance `gap` crowds a point (Yuksel's weight); symmetric. Gaps below `least` count as
/// `least`.
struct Crowding {
  double reach, least;
  double operator()(double gap) const {
    double weight = 1 - std::max(gap, least) / reach;
    for (int squarings = 0; squarings < 3; ++squarings) weight *= weight;
    return weight;
  }
};

struct Candidate {
  double weight;
  Index point;
  // The most crowded point comes first; of equals that with the higher index, so that the lower index stays.
  friend auto operator<=>(const Candidate&, const Candidate&) = default;
};

}  // namespace

std::vector<Index> eliminate(std::span<const Vec3> points, std::size_t kept, double area) {
  const double share = static_cast<double>(kept) / static_cast<double>(points.size());
  const double radius =
      std::sqrt(area / (2 * std::numbers::sqrt3 * static_cast<double>(kept)));  // of a hexagonal packing
  const Buckets buckets(points, 2 * radius);
  const Crowding crowding{2 * radius, 2 * radius * (1 - std::pow(share, 1.5)) * 0.65};

  std::vector<double> weight(points.size(), 0.0);
  std::vector<bool> alive(points.size(), true);
  std::priority_queue<Candidate> queue;
  for (Index i = 0; i < points.size(); ++i) {
    buckets.neighbours(i, [&](Index, double gap) { weight[i] += crowding(gap); });
    queue.push({weight[i], i});
  }
  // Weights only fall, so an entry that is out of date stands too early in the queue, never too late.
  for (std::size_t left = points.size(); left > kept;) {
    const Candidate top = queue.top();
    queue.pop();
    if (top.weight != weight[top.point]) {
      queue.push({weight[top.point], top.point});
      continue;
    }
    alive[top.point] = false;
    --left;
    buckets.neighbours(top.point, [&](Index other, double gap) { weight[other] -= crowding(gap); });
  }

  std::vector<Index> result;
  for (Index i = 0; i < points.size(); ++i)
    if (alive[i]) result.push_back(i);
  return result;
}

}  // namespace geodrome::shapes
