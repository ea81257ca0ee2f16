// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/search/smooth_distances.hpp"

namespace geodrome {

/// The distances of pairs by searches, one a pair by the rule of distances: on the triangles, and the smooth ones that
/// were made from these.
struct SearchedPairs {
  std::vector<double> flat, smooth;
  SmoothFigures paths;
  std::uint64_t searches = 0;
};

/// Searches once from every place that pairs begin at, over threads; the values are the same bytes for any number of
/// them. Throws CapabilityError if the solver cannot start at the first ends of pairs or answer at the second ones,
/// Cancelled, as `distance_row` and `smooth_row`. Precondition: the solver has a smooth metric and paths. O(pairs log
/// pairs) and the searches; memory: O(pairs), a search per thread.
SearchedPairs search_pairs(const PlacedSurface& surface, const PreparedSolver& solver, std::span<const NamedPair> pairs,
                           const RunSettings& settings, Observer& observer);

/// Measures a few of the pairs again, and audits the flat distances that theirs are made from: one line for each
/// promise that is broken. Throws as `search_pairs`.
std::vector<std::string> audit_searched(const PlacedSurface& surface, const PreparedSolver& solver,
                                        std::span<const NamedPair> pairs, std::span<const double> distances,
                                        const RunSettings& settings, Observer& observer);

}  // namespace geodrome
