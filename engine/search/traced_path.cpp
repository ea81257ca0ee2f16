// SPDX-License-Identifier: MIT
#include "engine/search/traced_path.hpp"

#include <algorithm>

#include "engine/surface/common_face.hpp"

namespace geodrome {

namespace {

/// The length of a polyline, weighted where the mesh has weights: there only the faces that hold a step tell its cost.
double length_of(const PathResult& path, const SurfaceMesh& mesh) {
  double length = 0;
  if (mesh.face_weights().empty()) {
    for (std::size_t i = 1; i < path.positions.size(); ++i)
      length += distance(path.positions[i - 1], path.positions[i]);
    return length;
  }
  const CommonFace common(mesh);
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const auto step = common.straight(path.points[i - 1], path.points[i]);
    if (!step)
      throw NumericalError("gave a path with a step that lies in no face",
                           "choose another solver, and report this to the author of the plugin");
    length += *step;
  }
  return length;
}

}  // namespace

PathResult trace_path(const PreparedSolver& solver, const ShortestPathMap& map, const SurfacePoint& to,
                      const SurfaceMesh& mesh) {
  PathResult result;
  // Solvers give the way from the target to the source.
  cross_boundary(solver.plugin.info, [&] { map.path(to, result.points); });
  std::reverse(result.points.begin(), result.points.end());
  for (const SurfacePoint& point : result.points) result.positions.push_back(mesh.position(point));
  result.length = cross_boundary(solver.plugin.info, [&] { return length_of(result, mesh); });
  return result;
}

}  // namespace geodrome
