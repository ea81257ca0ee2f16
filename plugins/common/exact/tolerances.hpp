// SPDX-License-Identifier: MIT
#pragma once

// What propagations of exact distances take for rounding, and how long a half-edge waits.

namespace geodrome {

/// A way is worse than another only if it is longer by this share: more than the rounding of any path, so that of two
/// equal ways none is dropped for the other.
inline constexpr double rounding_share = 1e-13;

/// A place nearer to another than this share of the length of an edge can no longer be told apart from it, seen from
/// that edge.
inline constexpr double close_share = 1e-8;

/// A half-edge leaves the queue at the least distance of what waits there plus this share of its length: late enough
/// that all sides have come, early enough that what depends on it need not be done again. 0.1 and 0.4 do as well.
inline constexpr double patience = 0.25;

}  // namespace geodrome
