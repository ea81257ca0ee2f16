// SPDX-License-Identifier: MIT
#pragma once

#include "engine/search/prepared_solver.hpp"
#include "geodrome/engine/distances.hpp"

namespace geodrome {

/// The shortest path of a map to `to`, from its source on: points, positions and length; `distance` is left alone.
/// Precondition: `to` was reached, and the map keeps paths. Throws NumericalError for a step that lies in no face of a
/// mesh with weights, and what the plugin throws.
PathResult trace_path(const PreparedSolver& solver, const ShortestPathMap& map, const SurfacePoint& to,
                      const SurfaceMesh& mesh);

}  // namespace geodrome
