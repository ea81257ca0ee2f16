// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome::chen_han {

/// A direction at a vertex as a share of its total angle, in `full_angle` steps, or one of the words behind it.
using DirectionCode = std::uint16_t;
inline constexpr DirectionCode full_angle = 65532;    ///< the total angle; around an inner vertex the same as 0
inline constexpr DirectionCode to_all_sides = 65534;  ///< of an arrival: a path may go on in any direction
inline constexpr DirectionCode ends_here = 65535;     ///< of an arrival: paths never bend there

/// A direct path, one that bends at no vertex on its way, as a search finds it.
struct FoundPath {
  double length;
  Index target;
  DirectionCode exit;     ///< the direction in which it leaves
  DirectionCode arrival;  ///< the direction, at the target, from which it came
};

/// Those of a list's directed paths that a path may go on by: `count` groups from `first` on, after the last the first
/// again. A group is one path, or a few in lists of more paths than 16 bits can count.
struct Onward {
  static constexpr std::uint16_t nowhere = 65535;
  static constexpr Index most_groups = nowhere - 1;

  std::uint16_t first = nowhere, count = 0;

  /// Whether a path ends at that vertex: it may not go on at all.
  bool ends() const { return first == nowhere; }
};

/// A direct path in a list, with those of its target that it may go on by.
struct DirectPath {
  double length;
  Index target;
  Onward onward;
};

/// The direct paths from a vertex that may be shortest: first those that any path may go on by, then the directed ones,
/// which leave in a direction of their own, in the order of directions.
class DirectList {
 public:
  /// A list without paths.
  DirectList() = default;
  /// Copies paths, of which the first `any` may be gone on by from any direction and the others are in order. Paths go
  /// on at an angle of at least `half_turn` to where they came from, on both sides; 0: in all directions. `closed`:
  /// directions go around the vertex.
  DirectList(std::span<const FoundPath> paths, std::size_t any, DirectionCode half_turn, bool closed);

  /// Returns the paths by which one that arrives from a direction may go on, with the rest of the groups at their two
  /// ends. O(log n).
  Onward onward(DirectionCode arrival) const;
  /// Completes the paths by what `lists`, those of all vertices, let them go on by. Called once; other lists may be
  /// completed at the same time. O(n log n).
  void complete(const std::vector<DirectList>& lists);

  std::span<const DirectPath> paths() const { return {paths_.get(), any_ + directed_}; }
  std::span<const DirectPath> for_any() const { return {paths_.get(), any_}; }
  std::span<const DirectPath> directed() const { return {paths_.get() + any_, directed_}; }
  /// Returns the directed paths of an onward that does not end, in two pieces. O(1).
  std::array<std::span<const DirectPath>, 2> directed(Onward onward) const;
  /// Tells whether these are all directed paths.
  bool is_all(Onward onward) const { return !onward.ends() && onward.count == groups_; }

  std::size_t bytes() const { return (any_ + directed_) * (sizeof(DirectPath) + sizeof(DirectionCode)); }

 private:
  Index first_from(int code) const;
  Onward grouped(Index first, Index count) const;

  std::unique_ptr<DirectPath[]> paths_;
  std::unique_ptr<DirectionCode[]> exits_;     ///< of the directed paths
  std::unique_ptr<DirectionCode[]> arrivals_;  ///< of all paths, until they are complete
  Index any_ = 0, directed_ = 0;
  std::uint16_t groups_ = 0, group_size_ = 1;  ///< of the directed paths; the last group may have fewer
  DirectionCode half_turn_ = 0;
  bool closed_ = false;
};

}  // namespace geodrome::chen_han
