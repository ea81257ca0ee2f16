// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "geodrome/engine/jobs.hpp"

namespace geodrome::bench {

/// The distance jobs whose audit is measured: on a mesh in a file, on one thread.
struct AuditJobs {
  std::filesystem::path mesh, folder;  ///< of what the jobs write
  std::vector<std::filesystem::path> plugin_path;
  std::string solver = "chen_han";
  double share = 0.01;  ///< of the audit

  /// A job from `sources`, as a list of rows, to all vertices; `nearest`: one search from all of them.
  DistanceJob job(const std::string& sources, bool nearest, double audit_share, std::uint64_t seed) const;
};

/// What a job takes without its audit and with it; medians over the rounds.
struct AuditCost {
  double seconds = 0, audited_seconds = 0;  ///< of processors
  double bytes = 0, audited_bytes = 0;      ///< resident at most
};

/// Runs the job `rounds` times without and with its audit by turns, each in a process of its own. Call it before a
/// thread was started and while this process is small: children begin with its memory.
AuditCost audit_cost(const AuditJobs& jobs, const std::string& sources, bool nearest, std::size_t rounds);

/// The number of seeds, from 1 on, at which a job of a faulty solver is found to break a promise, or ends with an error
/// of the solver. Each seed has its own random sources of the mesh's `vertices`, and faults where the solver draws
/// them.
struct AuditPower {
  std::size_t found = 0, found_without = 0;  ///< with the audit; by the other checks of a job alone
};
AuditPower audit_power(const AuditJobs& jobs, std::size_t vertices, std::size_t sources, bool nearest,
                       std::size_t seeds);

}  // namespace geodrome::bench
