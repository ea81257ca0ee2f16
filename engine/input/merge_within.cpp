// SPDX-License-Identifier: MIT
#include <algorithm>

#include "engine/input/merge.hpp"
#include "engine/input/point_tree.hpp"

namespace geodrome::input {
namespace {

/// Grows clusters of places, each from its first one.
class Clusters {
 public:
  Clusters(std::span<const Vec3> places, double tolerance)
      : places_(places), tolerance_(tolerance), tree_(tree_of(places)), first_(places.size(), no_index) {}

  MergedWithin run() {
    std::vector<bool> taken(places_.size());
    for (Index place = 0; place < places_.size() && result_.chained == no_index; ++place) {
      if (taken[place]) continue;
      first_[place] = place;
      take_joined(
          tree_, places_, place, taken, [&](Index) { return tolerance_; }, [](Index, Index) { return true; },
          [&](Index near) { return merge(near, place); });
    }
    if (result_.chained == no_index) number();
    return std::move(result_);
  }

 private:
  bool merge(Index place, Index first) {
    const double moved = distance(places_[place], places_[first]);
    if (moved > tolerance_) {
      result_.chained = place, result_.chained_to = first;
      return false;
    }
    result_.moved = std::max(result_.moved, moved);
    first_[place] = first;
    return true;
  }

  void number() {
    MergedPoints& merged = result_.merged;
    for (Index place = 0; place < places_.size(); ++place) {
      if (first_[place] != place) {
        merged.element_of_row.push_back(merged.element_of_row[first_[place]]);
        continue;
      }
      merged.element_of_row.push_back(static_cast<Index>(merged.positions.size()));
      merged.positions.push_back(places_[place]);
    }
  }

  std::span<const Vec3> places_;
  const double tolerance_;
  PointTree tree_;
  std::vector<Index> first_;  // per place: the first of its cluster
  MergedWithin result_;
};

}  // namespace

MergedWithin merge_points_within(std::span<const Vec3> points, double tolerance) {
  MergedPoints equal = merge_equal_points(points);
  if (tolerance == 0) return {std::move(equal)};
  MergedWithin within = Clusters(equal.positions, tolerance).run();
  const auto row_of = [&](Index place) {
    const auto found = std::ranges::find(equal.element_of_row, place);
    return static_cast<Index>(found - equal.element_of_row.begin());
  };
  if (within.chained != no_index) {
    within.chained = row_of(within.chained), within.chained_to = row_of(within.chained_to);
    return within;
  }
  for (Index& element : equal.element_of_row) element = within.merged.element_of_row[element];
  within.merged.element_of_row = std::move(equal.element_of_row);
  return within;
}

}  // namespace geodrome::input
