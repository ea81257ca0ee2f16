// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "plugins/common/mesh/packed_mesh.hpp"
#include "plugins/common/mesh/labels.hpp"
#include "plugins/solver_schreiber/kept_fronts.hpp"

namespace geodrome::schreiber {

/// A source in a face, by its name there.
struct SeededFace {
  SurfacePoint at;
  double start;
  Index number;
};

/// Follows kept fronts back to the source, face by face: in each the generator is looked up again, so that no error of
/// a direction adds up and thin triangles do no harm. What it follows was kept before what it comes from, so that it
/// never goes round, not even where faces without area meet in one place. Points are appended with the mesh's own face
/// numbers.
class PathTracer {
 public:
  PathTracer(const PackedMesh& surface, const Labels<Step>& labels, const KeptFronts& kept,
             const std::vector<SeededFace>& sources, std::vector<SurfacePoint>& out)
      : surface_(surface), labels_(labels), kept_(kept), sources_(sources), out_(out) {}

  /// From a vertex, which is appended first unless it is a source itself. O(faces crossed x generators of a front).
  void from_vertex(Index vertex);
  /// From a point of a half-edge, which is appended.
  void from_crossing(const Step& step);

 private:
  /// How a path goes on from a point of a half-edge into a face below it: across another half-edge, or (none) straight
  /// to a corner or a source in the face.
  struct Onward {
    double distance = std::numeric_limits<double>::infinity();
    Step step;
  };
  Index follow(Step step);
  void look_below(const Step& from, Index half_edge, double x, double most, Onward& best) const;
  void look_for_origin(const Step& from, Index half_edge, double x, Onward& best) const;
  Onward shortest_over_corners(Index half_edge, double x) const;

  const PackedMesh& surface_;
  const Labels<Step>& labels_;
  const KeptFronts& kept_;
  const std::vector<SeededFace>& sources_;
  std::vector<SurfacePoint>& out_;
};

}  // namespace geodrome::schreiber
