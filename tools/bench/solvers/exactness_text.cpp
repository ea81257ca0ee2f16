// SPDX-License-Identifier: MIT
#include <cstdio>

#include "tools/bench/solvers/exactness.hpp"

namespace geodrome::bench {

std::string exactness_names() {
  char line[160];
  std::snprintf(line, sizeof line, "%9s %9s %9s %9s %9s %9s %9s %9s %6s %9s %6s", "vertices", "points", "relative",
                "paths", "together", "scaled", "lipschitz", "a.paths", "peer x", "by", "wrong");
  return line;
}

std::string exactness_figures(const Exactness& result) {
  char line[240];
  std::snprintf(line, sizeof line, "%9.2g %9.2g %9.2g %9.2g %9.2g %9.2g %9.2g %9.2g %6zu %9.2g %6zu",
                result.at_vertices, result.at_points, result.relative, result.paths, result.together, result.scaled,
                result.lipschitz, result.audit_paths, result.peer_wrong, result.peer_error, result.solver_wrong);
  return line;
}

std::string exactness_notes(const Exactness& result) {
  std::string notes;
  if (!result.failure.empty()) notes += "    solver: " + result.failure + "\n";
  if (!result.peer_silent.empty()) notes += "    peer silent: " + result.peer_silent + "\n";
  if (!result.exact() && !result.where.empty()) notes += "    audit: " + result.where + "\n";
  return notes;
}

}  // namespace geodrome::bench
