// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/common/mesh/labels.hpp"
#include "plugins/solver_schreiber/kept_fronts.hpp"

namespace geodrome::schreiber {

/// A source in a face, named by the packed mesh.
struct SeededFace {
  SurfacePoint at;
  double start;
  Index number;
};

/// Follows kept fronts back to the source, face by face. The generator is looked up again in each face, so that no
/// error of a direction adds up and thin triangles do no harm. Each front that is followed was kept before the one it
/// leads from, so a path never goes round, not even where faces without area meet in one place. Points are appended
/// with the face numbers of the mesh itself.
class PathTracer {
 public:
  PathTracer(const PackedMesh& surface, const Labels<Step>& labels, const KeptFronts& kept,
             const std::vector<SeededFace>& sources, std::vector<SurfacePoint>& out)
      : surface_(surface), labels_(labels), kept_(kept), sources_(sources), out_(out) {}

  /// Traces the path from a vertex, which is appended first unless it is a source itself. O(faces crossed x generators
  /// of a front).
  void from_vertex(Index vertex);
  /// Traces the path from a point of a half-edge, which is appended.
  void from_crossing(const Step& step);

 private:
  /// The continuation of a path from a point of a half-edge into a face below it: across another half-edge, or, if
  /// `step` names none, straight to a corner or a source in the face.
  struct Onward {
    double distance = infinity;
    Step step;
  };
  /// The vertex that a path leads from: its distance, and the origin of the rays that reach it. From another point the
  /// distance is infinite.
  struct Start {
    double distance;
    Index origin;
  };
  void append(const SurfacePoint& point);
  Index follow(Step step, const Start& start);
  bool leads_on(const Start& start, Index origin) const;
  void look_below(const Step& from, const Start& start, Index half_edge, double x, double most, Onward& best) const;
  void look_for_origin(const Step& from, Index half_edge, double x, Onward& best) const;
  Onward shortest_over_corners(Index half_edge, double x, const Start& start) const;

  const PackedMesh& surface_;
  const Labels<Step>& labels_;
  const KeptFronts& kept_;
  const std::vector<SeededFace>& sources_;
  std::vector<SurfacePoint>& out_;
};

}  // namespace geodrome::schreiber
