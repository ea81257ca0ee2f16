// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "engine/search/target_list.hpp"
#include "geodrome/engine/distances.hpp"

namespace geodrome {

/// Judges a path that `shortest_path` gave: it runs on the surface from end to end, is as long as it says and, where
/// the solver promises it, as its distance, and a search from its other end finds the same distance within the factor.
/// One line for each promise that is broken. Throws what the solver throws.
std::vector<std::string> audit_path(const PreparedSolver& solver, const SurfaceMesh& mesh, const NamedPoint& from,
                                    const TargetList& to, const PathResult& path, RunContext& context);

/// Judges a path under a smooth metric: the path on the triangles by `audit_path`, of which this one is the shortened
/// curve, measured again.
std::vector<std::string> audit_smooth_path(const PreparedSolver& solver, const SurfaceMesh& mesh,
                                           const NamedPoint& from, const TargetList& to, const PathResult& path,
                                           RunContext& context);

}  // namespace geodrome
