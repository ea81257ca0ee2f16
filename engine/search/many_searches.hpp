// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/host/stage_context.hpp"
#include "engine/search/source_surface.hpp"
#include "geodrome/many_searches.hpp"

/// What the searches of many rows have in common, done once before all of them by a solver that can: the extension
/// ManySearches.
namespace geodrome {

/// The searches of a job's rows, as a solver is told of them: a SearchPlan that owns its sources.
struct RowPlan {
  std::vector<SurfacePoint> sources;  ///< each once, sorted: the order of the list is no matter
  double radius = 0;                  ///< the largest that one of them is searched with

  friend bool operator==(const RowPlan&, const RowPlan&) = default;
};

/// Plans the rows of a job, all of them: whichever are missing, their distances are the same bytes. Returns nothing
/// where the solver need not be asked: it has no such extension, sources have surfaces of their own, paths are wanted
/// for a smooth metric, or fewer than two places are searched from. O(n log n).
std::optional<RowPlan> plan_rows(const PreparedSolver& solver, ProjectionRule rule, std::span<const NamedPoint> sources,
                                 double max_distance);

/// What a solver made of a plan, for the report.
struct PlanRecord {
  bool used = false;        ///< false: the solver found that it would not pay
  std::size_t sources = 0;  ///< of the plan
  std::size_t bytes = 0;    ///< held for the searches, what was prepared before included; 0 if it is not used
  double seconds = 0;       ///< of preparing
  std::map<std::string, double> measures;
};

/// A solver that is ready for the searches of a plan.
struct PlannedSolver {
  PreparedSolver solver;  ///< with the surface for the plan, and what that may refer to; as it was if it is not used
  PlanRecord record;
};

/// Lets the solver prepare the plan. Precondition: `plan` is of `plan_rows` with this solver. Throws what the solver
/// throws, Cancelled.
PlannedSolver prepare_plan(const PreparedSolver& solver, const RowPlan& plan, StageContext& context);

}  // namespace geodrome
