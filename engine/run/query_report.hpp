// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/run/open_input.hpp"
#include "engine/run/pair_distances.hpp"
#include "engine/run/pair_index.hpp"
#include "geodrome/engine/jobs.hpp"

namespace geodrome {

/// All that a job of pair queries learned, from which its report is written.
struct QueryRecord {
  const QueryJob& job;
  const Opened& opened;
  const PreparedSolver& solver;
  const PairList& list;
  const ReadyOracle& oracle;
  const PairDistances& distances;
  double total_seconds = 0;
};

/// The report as JSON and as a few lines for people.
JobReport write_report(const QueryRecord& record);

/// The report of a job whose sample was refused, as JSON: what is known up to there.
std::string refusal_report(const QueryJob& job, const Opened& opened);

}  // namespace geodrome
