// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "engine/surface/common_face.hpp"
#include "tools/conformance/solver/solver_trial.hpp"

namespace geodrome::conformance {

/// One path on `mesh` from `point` to the nearest of the sources at `at`.
inline void judge_path(SolverTrial& t, const SurfaceMesh& mesh, const CommonFace& common, const ShortestPathMap& map,
                       const SurfacePoint& point, const std::vector<SurfacePoint>& at, double scale) {
  std::vector<SurfacePoint> path;
  map.path(point, path);
  const Index source = map.at(point).source;
  const bool on_mesh = std::ranges::all_of(path, [&](const SurfacePoint& p) { return p.face < mesh.face_count(); });
  t.holds(!path.empty() && on_mesh && source < at.size(), "a path on faces of the mesh to one of the sources",
          "from face ", point.face);
  if (path.empty() || !on_mesh || source >= at.size()) return;
  t.holds(path.front() == point, "it begins at the point", "from face ", point.face);
  t.near(common.straight(path.back(), at[source]).value_or(infinity), 0, rounding * scale,
         "distance of its end from the source, from face ", point.face);
  double length = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const auto step = common.straight(path[i], path[i + 1]);
    t.holds(step.has_value(), "a step within a face", "step ", i, " from face ", point.face);
    length += step.value_or(0);
  }
  if (t.has(Provides::path_is_distance))
    t.near(length, map.at(point).value, rounding * scale, "length, from face ", point.face);
  else if (t.approximates())  // the path may be nearer to the true distance
    t.same_distance(length, map.at(point).value, scale, "length, from face ", point.face);
  else
    t.at_least(length, map.at(point).value - rounding * scale, "length, from face ", point.face);
}

}  // namespace geodrome::conformance
