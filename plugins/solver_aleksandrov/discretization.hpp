// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/run_context.hpp"
#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/solver_aleksandrov/intrinsic/triangulation.hpp"
#include "plugins/solver_aleksandrov/steiner_graph.hpp"

namespace geodrome::aleksandrov {

enum class Triangulation {
  as_is,    ///< the faces of the mesh
  flipped,  ///< intrinsic Delaunay
  refined   ///< the same without thin faces
};

/// What the options of the plugin say.
struct Settings {
  double delta = 0.05;
  Placement placement = Placement::thin;
  Triangulation triangulation = Triangulation::refined;
  double least_angle = 20;  ///< degrees; refined only
  double thinning = 1;      ///< above 1 nothing is guaranteed
};

/// A surface made ready for approximate searches. Immutable; shared by threads.
class Discretization {
 public:
  /// O(F log F) and the Steiner points. Throws RefusedError if these are too many; may throw Cancelled.
  Discretization(const PackedMesh& surface, const Settings& settings, const RunContext& context);

  const PackedMesh& surface() const { return surface_; }
  const SteinerGraph& graph() const { return graph_; }

  /// A place of the flat surface in the triangulation of the graph; within rounding of an edge it is on the edge.
  SurfacePoint located(const SurfacePoint& flat) const;
  /// Appends the straight way between two places of a face of the graph's triangulation, as pieces in flat faces.
  void restore(Index face, const Barycentric& from, const Barycentric& to, std::vector<Piece>& out) const {
    triangulation_.restore(face, from, to, out);
  }
  std::size_t bytes() const { return triangulation_.bytes() + graph_.bytes(); }

 private:
  const PackedMesh& surface_;
  IntrinsicTriangulation triangulation_;
  SteinerGraph graph_;
};

}  // namespace geodrome::aleksandrov
