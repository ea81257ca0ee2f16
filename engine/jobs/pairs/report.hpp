// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/jobs/pairs/distances.hpp"
#include "engine/jobs/pairs/index.hpp"
#include "engine/jobs/start.hpp"
#include "geodrome/engine/jobs.hpp"

namespace geodrome {

/// All that a job of pair queries learned, from which its report is written.
struct PairRecord {
  const PairJob& job;
  const JobStart& start;
  const PreparedSolver& solver;
  const PairList& list;
  const ReadyOracle* oracle;  ///< null for smooth distances, which are searched for
  const PairDistances& distances;
  OffSurface off_surface;
  double total_seconds = 0;
};

/// The report as JSON and as a few lines for people.
JobReport write_report(const PairRecord& record);

/// The report of a job whose sample was refused, as JSON: what is known up to there.
std::string refusal_report(const PairJob& job, const JobStart& start);

}  // namespace geodrome
