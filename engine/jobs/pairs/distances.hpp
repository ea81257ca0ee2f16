// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/checks/pair_audit.hpp"
#include "engine/jobs/pairs/searches.hpp"
#include "engine/search/reach.hpp"
#include "geodrome/engine/named_points.hpp"

namespace geodrome {

/// The distances of pairs, and what was checked of them.
struct PairDistances {
  std::vector<double> values;  ///< one a pair; +inf: unreachable, NaN: an end was dropped
  ReachCounts reach;           ///< `beyond_limit` is none
  std::uint64_t asked = 0;     ///< of the oracle; the others have a dropped or isolated end
  std::uint64_t searches = 0;  ///< in place of the oracle
  std::uint64_t below_euclid = 0,
                not_zero = 0;  ///< faults: shorter than the straight line; points away from themselves
  PairAudit audit;
  std::optional<SmoothFigures> smooth;  ///< if `values` are smooth; the checks are of the flat ones
  double seconds = 0;                   ///< wall clock, of all queries
  unsigned threads = 1;                 ///< that took part

  /// The time of one query, on one thread; 0 if there was none.
  double microseconds() const { return asked == 0 ? 0 : seconds * 1e6 * threads / static_cast<double>(asked); }
  bool sound() const {
    return reach.missed == 0 && reach.impossible == 0 && below_euclid == 0 && not_zero == 0 && audit.holds();
  }
};

/// The distances of pairs by `oracle`, which `solver` made of the surface, over at most `threads` threads; the values
/// are the same bytes for any number. Throws NumericalError, naming pair and plugin, for what is no number >= 0,
/// Cancelled, and what the plugin throws.
std::vector<double> ask_pairs(const PlacedSurface& surface, const PreparedSolver& solver, const PairOracle& oracle,
                              std::span<const NamedPair> pairs, unsigned threads, RunContext& context);

/// Asks `oracle`, which `solver` made of the surface, for all pairs, as `ask_pairs`, and checks the answers: on surface
/// distances, with the tolerance of `check_invariants`; a few pairs are searched for anew. Throws as `ask_pairs`.
PairDistances pair_distances(const PlacedSurface& surface, const PreparedSolver& solver, const PairOracle& oracle,
                             std::span<const NamedPair> pairs, unsigned threads, RunContext& context);

/// Smooth distances of pairs by `search_pairs`, and the same checks of the flat ones.
PairDistances pair_distances(const PlacedSurface& surface, const PreparedSolver& solver,
                             std::span<const NamedPair> pairs, const RunSettings& settings, Observer& observer);

}  // namespace geodrome
