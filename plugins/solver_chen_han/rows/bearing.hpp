// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace geodrome::chen_han {

/// A direction at the source of a run, counted over all its faces, so that it may exceed a full turn: a whole number of
/// 2^-59 full turns. A sum has no error but that of its terms, so a path across a million faces, or as many faces
/// around a vertex, leave it exact to 1e-9 rad. Even, unless it is unknown: adding a known one to an unknown one gives
/// an unknown one.
using Bearing = std::uint64_t;

inline constexpr Bearing unknown_bearing = 1;
/// Bearings tell angles up to so many radians apart.
inline constexpr double largest_angle = 14 * 2 * std::numbers::pi;

namespace detail {
inline constexpr double steps_a_radian = static_cast<double>(std::uint64_t{1} << 58) / (2 * std::numbers::pi);
}

inline bool is_known(Bearing bearing) { return bearing % 2 == 0; }
/// Precondition: the angle is at most `largest_angle`, of either sign.
inline Bearing bearing_of(double radians) {
  return 2 * static_cast<Bearing>(std::llrint(radians * detail::steps_a_radian));
}
inline double radians(Bearing bearing) {
  return static_cast<double>(static_cast<std::int64_t>(bearing)) / (2 * detail::steps_a_radian);
}

}  // namespace geodrome::chen_han
