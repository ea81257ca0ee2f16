// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Surface_mesh_shortest_path.h>

#include <memory>
#include <vector>

#include "geodrome/shortest_path_solver.hpp"
#include "plugins/solver_cgal/cgal_surface.hpp"

namespace geodrome::cgal {

/// A mesh and its copy for CGAL, which all searches share.
struct Prepared {
  MeshPtr mesh;
  Normalisation normalisation;
  Mesh copy;
  std::vector<Index> component;

  /// O(V + F). Throws CapabilityError if CGAL refuses a face.
  explicit Prepared(MeshPtr input);
};

/// CGAL's search from one source: its sequence tree, which answers at any point. CGAL takes several sources as well,
/// but then drops windows that are needed: its rule "one angle, one split" compares a window with the one that occupies
/// the corner of its face as if both came through the same edge, which the window of a source inside the face did not.
class SourceTree {
 public:
  /// Builds the tree. Throws NumericalError where CGAL fails, Cancelled.
  SourceTree(std::shared_ptr<const Prepared> prepared, const SurfacePoint& source, const RunContext& context);

  /// The distance of a vertex or of any point, in the units of the mesh; +inf in another component. Throws
  /// NumericalError where CGAL finds no way though there is one.
  double at_vertex(Index vertex) const;
  double at(const SurfacePoint& point) const;

  /// Appends the way from a point in the source's component to the source. Throws NumericalError for one that is not as
  /// long as the distance.
  void trace(const SurfacePoint& point, std::vector<SurfacePoint>& out) const;

 private:
  using ShortestPaths = CGAL::Surface_mesh_shortest_path<LayoutTraits>;
  using FaceLocation = ShortestPaths::Face_location;
  using Vertex = Mesh::Vertex_index;

  /// CGAL's answer at a point that was asked in place of another.
  struct Answer {
    ShortestPaths::Shortest_path_result found;
    SurfacePoint asked;
  };

  const SurfaceMesh& mesh() const { return *prepared_->mesh; }
  static FaceLocation location_of(const SurfacePoint& point);
  void add_source();
  Answer best_near(const SurfacePoint& point) const;
  Answer ask(const SurfacePoint& point, double away) const;
  double judge(const ShortestPaths::Shortest_path_result& found, Index vertex, const std::string& where) const;
  void require_length(const std::vector<SurfacePoint>& path, double distance) const;

  std::shared_ptr<const Prepared> prepared_;
  SurfacePoint source_;
  CancelPoll poll_;
  mutable ShortestPaths paths_;  // CGAL's queries are not const: they build the tree on demand
};

}  // namespace geodrome::cgal
