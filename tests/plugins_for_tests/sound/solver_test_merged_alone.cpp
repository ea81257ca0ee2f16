// SPDX-License-Identifier: MIT
// The solver of merged windows without its way out: long lists are carried on, so that what is judged is the merging.
#include "geodrome/lower_bounds.hpp"
#include "geodrome/plugin.hpp"
#include "plugins/common/exact/exact_prepared.hpp"
#include "plugins/solver_merged_windows/bounded_search.hpp"
#include "plugins/solver_merged_windows/merged_windows.hpp"

namespace {

using namespace geodrome;
using merged_windows::BoundedSearch;

class Solver final : public ShortestPathSolver {
 public:
  explicit Solver(const OptionValues& values) : settings_(MergedWindowsSolver::options.parsed(values)) {
    settings_.long_list = settings_.many_tries = infinity, settings_.few_faces = 0;
  }

  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext& context) const override {
    return prepare_exact<merged_windows::Fallback, BoundedSearch>(std::move(mesh), settings_, context);
  }

 private:
  merged_windows::Settings settings_;
};

constexpr LowerBounds lower_bounds{
    [](const ShortestPathMap& map, std::span<double> bounds) noexcept {
      BoundedSearch::of(map).write_lower_bounds(bounds);
    },
    [](const ShortestPathMap& map, const SurfacePoint& point) { return BoundedSearch::of(map).lower_bound_at(point); }};

}  // namespace

GEODROME_PLUGIN(Solver, .name = "test_merged_alone", .summary = "merged windows, however long their lists are",
                .licence = "MIT", .provides = MergedWindowsSolver::provides, .options = MergedWindowsSolver::options,
                .factor = MergedWindowsSolver::factor, .extension = extensions<lower_bounds>)
