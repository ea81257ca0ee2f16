// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geodrome/run_context.hpp"
#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/solver_chen_han/rows/direct_search.hpp"

namespace geodrome::chen_han {

/// What a search took on average, by counts that are the same on every machine.
struct SearchCounts {
  double passes = 0, windows = 0;  ///< of lists of windows, of windows
  double bounds = 0;               ///< paths tried for bounds, in a direct search
  double paths = 0;                ///< direct paths, in a direct search
  double bends = 0;                ///< vertices reached at which paths can bend, in a plain search

  /// Returns about how long it took, in units of 10 ns on a processor of 2025: plain, or direct with its list.
  double plain_work() const { return 30 * passes + 0.25 * windows; }
  double direct_work() const { return plain_work() + 0.3 * bounds + 12 * paths; }
};

/// The work of a plan by lists of direct paths against that of plain searches.
struct RowEstimate {
  SearchCounts plain, direct;
  std::size_t sources, searches, lists;  ///< sources of the plan, direct searches, those of them for lists

  double plain_work() const { return plain.plain_work() * static_cast<double>(sources); }
  /// Direct searches; and for each source its own direct paths, and a look at the list of each vertex at which paths
  /// can bend.
  double list_work() const {
    const double row = 4 * direct.paths + 20 * plain.bends;
    return direct.direct_work() * static_cast<double>(searches) + row * static_cast<double>(sources);
  }
  double share() const { return list_work() / plain_work(); }
  /// Returns the bytes of the lists.
  double bytes() const {
    return static_cast<double>(lists) * direct.paths * (sizeof(DirectPath) + sizeof(DirectionCode));
  }
};

/// A few sources, spread evenly over those of a plan: so few that their searches cost next to nothing beside all.
std::vector<Index> samples(std::span<const Index> sources);

/// Returns the work of near lists on most meshes, in the units of SearchCounts: from every vertex a search that passes
/// a few half-edges for each.
inline double usual_near_work(const PackedMesh& surface) {
  return 30 * 6.0 * DirectGround::near_count * static_cast<double>(surface.vertex_count());
}
/// Tells whether near lists would take more than some work, by what a few vertices take. Those beside a vertex of very
/// many faces are counted apart, for what they take depends on it. Finding out takes `most_work` and one search at
/// most. Throws Cancelled.
bool near_lists_take_more(const PackedMesh& surface, const Settings& settings, double most_work,
                          const RunContext& context);

/// Averages over searches from samples, up to a distance. Throws Cancelled.
SearchCounts count_plain(const PackedMesh& surface, const Settings& settings, std::span<const Index> samples,
                         double distance, const RunContext& context);
SearchCounts count_direct(const PackedMesh& surface, const Settings& settings, const DirectGround& ground,
                          std::span<const Index> samples, double distance, const RunContext& context);

}  // namespace geodrome::chen_han
