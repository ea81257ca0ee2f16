// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "geodrome/surface.hpp"

namespace geodrome {

/// The rule for a place off the surface (Section 2.4, Algorithm 2).
///
/// `project`: its closest surface point, D = max(surface distance, |st|); one surface, so D is symmetric and keeps the
/// triangle inequality up to the bound. `insert`: the paper's S_conf + s_src: each source becomes a vertex of a surface
/// of its own, targets are its closest points, D as above; better for near pairs and coarse samples, not symmetric.
/// `printed`: the same surfaces, targets by lines 12 to 19 as printed, D unbounded below; for comparison only: it is 0
/// where a target's nearest vertex is the source. The last two need a point sample and rows of it as sources.
enum class ProjectionRule { project, insert, printed };

/// Options for distances from sources to targets.
struct DistanceOptions {
  double max_distance = infinity;  ///< farther is +inf
  ProjectionRule rule = ProjectionRule::project;
};

/// Distances and their lower bounds, each a row per source. No true distance on the surface is below its bound, which
/// is finite where the distance is +inf because of a limit only.
struct BoundedDistances {
  std::vector<double> distances, bounds;
};

/// The polyline on the triangles that a curve on the smooth surface was made from; empty if unreachable.
struct FlatPath {
  double length = 0;
  std::vector<SurfacePoint> points;
  std::vector<Vec3> positions;
};

/// A polyline of surface points from `from` to `to`; empty if unreachable, then `distance` is +inf, and if both are the
/// same vertex on no face, then it is 0. Faces are those of the surface; under `insert` of the one with `from` as a
/// vertex, on which faces that stayed should have kept their index.
struct PathResult {
  /// max(surface distance, |st|) for a cloud. The surface distance is the solver's, or the length of the path where
  /// that is shorter: with an approximate solver no true distance is longer than a path, so that it is nearer.
  double distance = 0;
  double length = 0;  ///< of the polyline, weighted by the faces that it crosses if they have weights
  std::vector<SurfacePoint> points;
  std::vector<Vec3> positions;
  std::optional<FlatPath> flat;                     ///< if the metric is smooth
  double from_off_surface = 0, to_off_surface = 0;  ///< as `NamedPoint::off_surface` of the ends
  std::vector<std::string> broken_promises;         ///< what `run_path` found in its audit; of a session empty
};

}  // namespace geodrome
