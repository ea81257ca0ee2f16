// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/smooth/charts.hpp"

namespace geodrome {

/// The smooth surface above a vertex.
struct VertexShape {
  Vec3 position, normal;
  std::array<Vec3, 3> turn;  ///< rows of the matrix by which the normal changes when the point moves; symmetric
  double curvature = 0;      ///< Gaussian
};

/// A point of a curve: its place, two derivatives, the normal of the surface.
struct CurvePoint {
  Vec3 position, first, second, normal;
};

/// The smooth surface above an edge, as polynomials of degree 5 in the share of the edge, from its first vertex on: the
/// coefficients of its powers.
struct EdgeCurve {
  static constexpr int size = 6;

  std::array<Vec3, size> position{}, normal{};  // the normal: of unit length but for the polynomial's error
  Index from = no_index, to = no_index;
  double length = 0;     ///< of the straight line between its ends
  bool trusted = false;  ///< all faces of the edge are; else nothing is known of it

  /// The share may lie a little outside of [0, 1].
  CurvePoint at(double share) const;
};

/// A smooth surface above vertices and edges of a mesh, tabulated once for all sources: what marching asks again and
/// again. Immutable; thread-safe.
class EdgeCurves {
 public:
  /// Precondition: the mesh is manifold and oriented. O(V + F). `charts` must outlive it.
  explicit EdgeCurves(const SmoothCharts& charts);

  const SmoothCharts& charts() const { return charts_; }
  const SurfaceMesh& mesh() const { return charts_.mesh(); }
  const VertexShape& vertex(Index v) const { return vertices_[v]; }
  const EdgeCurve& edge(Index half_edge) const { return edges_[edge_of_[half_edge]]; }
  /// The half-edge runs as its edge does.
  bool forward(Index half_edge) const { return mesh().from(half_edge) == edge(half_edge).from; }

  /// The half-edges that start at a vertex, one for each of its faces.
  std::span<const Index> starting_at(Index v) const {
    return {around_.data() + first_[v], around_.data() + first_[v + 1]};
  }

  /// The Gaussian curvature above a point: of second order within a face, from the vertices and the middles of edges.
  double curvature(const SurfacePoint& at) const;

 private:
  void index_edges();
  void trace_edge(Index half_edge, EdgeCurve& curve) const;
  void trace_edges();
  void shape_vertices();
  void bend_edges();

  const SmoothCharts& charts_;
  std::vector<Index> edge_of_, first_, around_;
  std::vector<VertexShape> vertices_;
  std::vector<EdgeCurve> edges_;
  std::vector<double> curvature_;  // in the middle of each edge
};

}  // namespace geodrome
