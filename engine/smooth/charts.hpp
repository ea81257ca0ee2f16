// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/surface/common_face.hpp"
#include "geodrome/smooth_surface.hpp"

namespace geodrome {

/// A straight piece of a path, within one face.
struct FlatPiece {
  Index face = no_index;
  std::array<double, 3> from{}, to{};
  double length = 0;
};

/// A mesh with a smooth surface over it, and what shortening asks of its faces again and again. Immutable; thread-safe.
class SmoothCharts {
 public:
  /// O(V + F).
  SmoothCharts(MeshPtr mesh, std::shared_ptr<const SmoothSurface> surface);

  const SurfaceMesh& mesh() const { return *mesh_; }
  const SmoothSurface& surface() const { return *surface_; }

  /// Faces that are not trusted stay flat, and so do those without an area: they have no plane to move in.
  bool trusts(Index face) const { return expected_error_[face] < infinity; }
  /// How far a curve is expected to be off over the face (error_estimate.hpp); infinite where it is not trusted.
  double expected_error(Index face) const { return expected_error_[face]; }
  /// How far apart nodes are to lie: the mean length of the face's edges.
  double spacing(Index face) const { return spacing_[face]; }

  /// A surface point as coordinates on a face, if that holds it.
  std::optional<std::array<double, 3>> on_face(const SurfacePoint& point, Index face) const {
    return common_.on_face(point, face);
  }

  /// Replaces `pieces` by those of a path, without those that have no length. A piece along an edge lies in a face that
  /// is trusted if there is one, in the lowest of them. Throws NumericalError for a step that lies in no face.
  void cut(std::span<const SurfacePoint> path, std::vector<FlatPiece>& pieces) const;

 private:
  FlatPiece piece(const SurfacePoint& p, const SurfacePoint& q) const;

  MeshPtr mesh_;
  std::shared_ptr<const SmoothSurface> surface_;
  CommonFace common_;
  std::vector<double> expected_error_, spacing_;
};

}  // namespace geodrome
