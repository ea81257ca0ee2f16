// SPDX-License-Identifier: MIT
#include "geodrome/plugin.hpp"
#include "geodrome/lower_bounds.hpp"
#include "plugins/solver_merged_windows/bounded_search.hpp"
#include "plugins/solver_merged_windows/merged_windows.hpp"

namespace geodrome::merged_windows {
namespace {

constexpr LowerBounds lower_bounds{
    [](const ShortestPathMap& map, std::span<double> bounds) noexcept {
      BoundedSearch::of(map).write_lower_bounds(bounds);
    },
    [](const ShortestPathMap& map, const SurfacePoint& point) { return BoundedSearch::of(map).lower_bound_at(point); }};

}  // namespace
}  // namespace geodrome::merged_windows

GEODROME_PLUGIN(geodrome::MergedWindowsSolver, .name = "merged_windows",
                .summary = "within a factor of 1 + delta, by merged windows (after Surazhsky et al. 2005)",
                .licence = "MIT", .provides = geodrome::MergedWindowsSolver::provides,
                .options = geodrome::MergedWindowsSolver::options, .factor = geodrome::MergedWindowsSolver::factor,
                .extension = geodrome::extensions<geodrome::merged_windows::lower_bounds>)
