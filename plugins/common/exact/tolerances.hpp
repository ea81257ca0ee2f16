// SPDX-License-Identifier: MIT
#pragma once

// The tolerances of propagations of exact distances, how long a half-edge waits, and how much a search may carry.
#include <cstdint>

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

/// Returns how many straight lines (windows, generators) a search may carry across faces. On a manifold a search needs
/// at most one for each face on each level of Chen and Han's sequence tree, which has as many levels as there are
/// faces: F^2. Sixteen times that leaves room for what is carried again; a million more, for small meshes. Where edges
/// have more than two faces no bound is known.
inline std::uint64_t most_carried(std::uint64_t faces) { return 16 * faces * faces + (std::uint64_t{1} << 20); }

}  // namespace geodrome
