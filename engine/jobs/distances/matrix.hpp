// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>

#include "engine/checks/interval_audit.hpp"
#include "engine/checks/invariants.hpp"
#include "engine/checks/row_audit.hpp"
#include "engine/search/reach.hpp"
#include "engine/search/source_surface.hpp"
#include "geodrome/engine/jobs.hpp"

namespace geodrome {

/// The result of making a matrix.
struct MatrixResult {
  std::uint64_t rows = 0, columns = 0, bytes = 0, resumed_rows = 0;
  double first_row_seconds = 0, seconds = 0;
  std::map<std::string, std::uint64_t> counters;    ///< of the searches of this run
  std::map<std::string, std::uint64_t> insertions;  ///< how this run's sources became vertices; none for `project`
  ReachCounts reach;
  Invariants invariants;
  std::optional<IntervalFigures> certified;  ///< by the searches of this run, if the solver states lower bounds
  RowsAudit audit;
};

/// Computes, checks and finishes `job.matrix`, and `job.bounds` if that is named: rows over threads, each written as
/// soon as it is there. Before the bulk of the work it times one row, tells size and estimated time, and throws
/// RefusedError without consent above 4 GB or room on disk. Interrupted, it leaves MATRIX.partial. The finished matrix
/// is audited (`RowAudit`). Memory: one row per thread, and what three searches found at the vertices. Under a rule
/// that inserts sources, each thread prepares one surface at a time beside `solver`'s.
MatrixResult compute_matrix(const DistanceJob& job, const PreparedSolver& solver, const SourceSurfaces& surfaces,
                            std::span<const NamedPoint> sources, const std::string& fingerprint, Observer& observer);

}  // namespace geodrome
