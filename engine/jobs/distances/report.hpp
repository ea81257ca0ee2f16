// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/jobs/distances/matrix.hpp"
#include "engine/jobs/distances/nearest.hpp"
#include "engine/jobs/start.hpp"
#include "geodrome/engine/jobs.hpp"

namespace geodrome {

/// All that a distance job learned, from which its report is written.
struct RunRecord {
  const DistanceJob& job;
  const JobStart& start;
  const PreparedSolver& solver;
  std::size_t source_count = 0, target_count = 0;
  OffSurface off_surface;                 ///< sources and targets
  std::vector<Finding> surface_findings;  ///< of the file of the surface
  std::optional<MatrixResult> matrix;
  std::optional<NearestResult> nearest;
  double total_seconds = 0;
};

/// The report as JSON and as a few lines for people.
JobReport write_report(const RunRecord& record);

/// The report of a job whose sample was refused, as JSON: what is known up to there.
std::string refusal_report(const DistanceJob& job, const JobStart& start);

}  // namespace geodrome
