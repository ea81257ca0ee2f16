// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>

#include "engine/checks/interval_audit.hpp"
#include "engine/checks/invariants.hpp"
#include "engine/checks/row_audit.hpp"
#include "engine/search/many_searches.hpp"
#include "engine/search/reach.hpp"
#include "engine/search/smooth_distances.hpp"
#include "engine/search/source_surface.hpp"
#include "geodrome/engine/jobs.hpp"

namespace geodrome {

/// The result of making a matrix.
struct MatrixResult {
  std::uint64_t rows = 0, columns = 0, bytes = 0, resumed_rows = 0;
  double first_row_seconds = 0, seconds = 0;
  std::map<std::string, std::uint64_t> counters;    ///< of the searches of this run
  std::map<std::string, std::uint64_t> insertions;  ///< how this run's sources became vertices; none for `project`
  std::optional<PlanRecord> plan;       ///< of the rows of this run, if the solver was asked to prepare them together
  std::optional<SmoothFigures> smooth;  ///< of the rows of this run, under a smooth metric
  ReachCounts reach;
  Invariants invariants;
  std::optional<IntervalFigures> certified;  ///< by the searches of this run, if the solver states lower bounds
  RowsAudit audit;
};

/// Computes, checks and finishes `job.matrix`, and `job.bounds` if that is named: rows over threads, each written as
/// soon as it is there. Before the bulk of the work it times one row, tells size and estimated time, and throws
/// RefusedError without consent above 4 GB or room on disk. Interrupted, it leaves MATRIX.partial. The finished matrix
/// is audited (`RowAudit`); of smooth distances the flat ones are, which they were made from.
///
/// A solver that offers it prepares all rows together before the first that is missing (`plan_rows`), whichever are
/// missing, so that their bytes do not depend on it. The row that is timed, the first, and the searches of the audit
/// are made without that: they check it.
///
/// Memory: one row per thread, what three searches found at the vertices, and while rows are made what the solver
/// prepared for them. Under a rule that inserts sources, each thread prepares one surface at a time beside `solver`'s.
MatrixResult compute_matrix(const DistanceJob& job, const PreparedSolver& solver, const SourceSurfaces& surfaces,
                            std::span<const NamedPoint> sources, const std::string& fingerprint, Observer& observer);

}  // namespace geodrome
