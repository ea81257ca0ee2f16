// SPDX-License-Identifier: MIT
#pragma once

// The tolerances of propagations of exact distances, and how long a half-edge waits.

namespace geodrome {

/// A path is worse than another only if it is longer by this share. The share exceeds the rounding of any path, so that
/// neither of two equal paths is dropped for the other.
inline constexpr double rounding_share = 1e-13;

/// Two places cannot be told apart any more, seen from an edge, if they are nearer to each other than this share of its
/// length.
inline constexpr double close_share = 1e-8;

/// Two places are the same, up to rounding, if they are nearer to each other than this share of an edge at them.
inline constexpr double same_place_share = 1e-16;

/// A half-edge leaves the queue at the least distance of what waits there plus this share of its length: late enough
/// that all sides have arrived, early enough that what depends on it need not be done again. 0.1 and 0.4 do as well.
inline constexpr double patience = 0.25;

}  // namespace geodrome
