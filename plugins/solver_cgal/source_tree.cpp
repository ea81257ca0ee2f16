// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/solver_cgal/source_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "geodrome/vertex_components.hpp"
#include "plugins/common_gpl/guarded.hpp"

namespace geodrome::cgal {
namespace {

/// Not 0, but without weight beside any coordinate: CGAL 5.5 mirrors a source on an edge about the edge's middle
/// (expand_edge_root swaps the two weights), but not one that is just inside a face.
constexpr double just_inside = std::numeric_limits<double>::min();

/// How far beside a point `best_near` asks, relative to the distance from the source (rounding of unfolded coordinates
/// grows with it), and at most, relative to the way to a corner.
constexpr double beside = 32 * std::numeric_limits<double>::epsilon(), most_beside = 1e-9;

/// Calls a function that uses CGAL, whose failures become NumericalErrors.
template <class Function>
decltype(auto) ask_cgal(Function&& function) {
  return geodrome::guarded(std::forward<Function>(function),
                           "check the mesh for needle faces and faces without area, or choose another solver");
}

/// Collects the path that CGAL reports as faces, edges and vertices.
struct PathCollector {
  const SurfaceMesh& mesh;
  const Mesh& copy;
  std::vector<SurfacePoint>& out;

  void operator()(Mesh::Face_index face, const LayoutTraits::Barycentric_coordinates& b) {
    out.push_back({static_cast<Index>(face), {b[0], b[1], b[2]}});
  }
  void operator()(Mesh::Vertex_index vertex) { out.push_back(mesh.at_vertex(static_cast<Index>(vertex))); }

  /// `t` is the weight of the half-edge's target; rounding can put it a little outside [0, 1].
  void operator()(Mesh::Halfedge_index edge, double t) {
    if (copy.is_border(edge)) edge = copy.opposite(edge), t = 1 - t;
    t = std::clamp(t, 0.0, 1.0);
    SurfacePoint point{static_cast<Index>(copy.face(edge)), {}};
    const Triangle& corners = mesh.triangles()[point.face];
    for (int i = 0; i < 3; ++i) {
      if (corners[i] == static_cast<Index>(copy.source(edge))) point.b[i] = 1 - t;
      if (corners[i] == static_cast<Index>(copy.target(edge))) point.b[i] = t;
    }
    out.push_back(point);
  }
};

/// One name for each point, so that one place gives the same bytes whichever face names it: of a point on an edge or at
/// a vertex that in the lowest face.
SurfacePoint canonical(const SurfaceMesh& mesh, const SurfacePoint& point) {
  if (const Index vertex = mesh.vertex_at(point); vertex != no_index) return mesh.at_vertex(vertex);
  for (Index i = 0; i < 3; ++i) {
    const Index edge = 3 * point.face + (i + 1) % 3, twin = mesh.twins()[edge];
    if (point.b[i] != 0 || twin == no_index || twin > edge) continue;
    SurfacePoint other{SurfaceMesh::face(twin), {}};
    other.b[twin % 3] = point.b[(i + 2) % 3];
    other.b[(twin + 1) % 3] = point.b[(i + 1) % 3];
    return other;
  }
  return point;
}

}  // namespace

Prepared::Prepared(MeshPtr input)
    : mesh(std::move(input)),
      normalisation(*mesh),
      copy(copy_for_cgal(*mesh, normalisation)),
      component(vertex_components(*mesh)) {}

SourceTree::SourceTree(std::shared_ptr<const Prepared> prepared, const SurfacePoint& source, const RunContext& context)
    : prepared_(std::move(prepared)),
      source_(canonical(mesh(), source)),
      paths_(prepared_->copy, LayoutTraits(&poll_)) {
  add_source();
  poll_.watch(&context);
  ask_cgal([&] { paths_.build_sequence_tree(); });
  poll_.watch(nullptr);
}

SourceTree::FaceLocation SourceTree::location_of(const SurfacePoint& p) {
  return {Mesh::Face_index(p.face), LayoutTraits::Barycentric_coordinates{p.b[0], p.b[1], p.b[2]}};
}

/// A source on an edge becomes one just inside each of its faces.
void SourceTree::add_source() {
  FaceLocation here = location_of(source_);
  const auto zero = std::find(source_.b.begin(), source_.b.end(), 0.0);
  if (std::count(source_.b.begin(), source_.b.end(), 0.0) != 1) return void(paths_.add_source_point(here));
  const int i = static_cast<int>(zero - source_.b.begin());
  here.second[i] = just_inside;
  paths_.add_source_point(here);
  const Index edge = 3 * source_.face + (i + 1) % 3, twin = mesh().twins()[edge];
  if (twin == no_index) return;
  FaceLocation there{Mesh::Face_index(SurfaceMesh::face(twin)), {just_inside, just_inside, just_inside}};
  there.second[twin % 3] = source_.b[(i + 2) % 3];
  there.second[(twin + 1) % 3] = source_.b[(i + 1) % 3];
  paths_.add_source_point(there);
}

double SourceTree::at_vertex(Index vertex) const {
  if (mesh().first_half_edge(vertex) == no_index) return infinity;
  const auto found = ask_cgal([&] { return paths_.shortest_distance_to_source_points(Vertex(vertex)); });
  return judge(found, vertex, "vertex " + std::to_string(vertex));
}

double SourceTree::at(const SurfacePoint& point) const {
  if (const Index vertex = mesh().vertex_at(point); vertex != no_index) return at_vertex(vertex);
  return judge(best_near(point).found, mesh().triangles()[point.face][0],
               "a point of face " + std::to_string(point.face));
}

/// Windows are closed sets with rounded corners: a point on the common border of two can be in neither, and CGAL then
/// answers with a third that is far too long. So three points beside it, farther away than the rounding, are asked too;
/// each gives an upper bound that is as good.
SourceTree::Answer SourceTree::best_near(const SurfacePoint& point) const {
  Answer best = ask(point, 0);
  const auto corners = mesh().corners(point.face);
  const Vec3 here = mesh().position(point);
  for (int i = 0; i < 3; ++i) {
    const double side = std::ldexp(distance(corners[i], here), prepared_->normalisation.exponent);
    const Vertex corner(mesh().triangles()[point.face][i]);
    const double reach = std::abs(paths_.shortest_distance_to_source_points(corner).first) + side;
    const double share = side > 0 ? std::min(beside * reach / side, most_beside) : 0;
    SurfacePoint near = point;
    for (double& b : near.b) b *= 1 - share;
    near.b[i] += share;
    const Answer other = ask(near, share * side);
    const bool nothing = best.found.second == paths_.source_points_end();
    if (nothing || (other.found.first >= 0 && other.found.first < best.found.first)) best = other;
  }
  return best;
}

SourceTree::Answer SourceTree::ask(const SurfacePoint& point, double away) const {
  const auto [face, b] = location_of(point);
  Answer answer{ask_cgal([&] { return paths_.shortest_distance_to_source_points(face, b); }), point};
  if (answer.found.first >= 0) answer.found.first += away;
  return answer;
}

/// CGAL says -1 where it found no way. That is right only in a component without the source.
double SourceTree::judge(const ShortestPaths::Shortest_path_result& found, Index vertex,
                         const std::string& where) const {
  const bool nothing = found.second == paths_.source_points_end();
  const Index of_source = prepared_->component[mesh().triangles()[source_.face][0]];
  if (nothing && prepared_->component[vertex] != of_source) return infinity;
  if (nothing || !(found.first >= 0) || !std::isfinite(found.first))
    throw NumericalError("CGAL found no distance for " + where + ", which can be reached",
                         "check the mesh for needle faces and faces without area, or choose another solver");
  return prepared_->normalisation.original(found.first);
}

void SourceTree::trace(const SurfacePoint& point, std::vector<SurfacePoint>& out) const {
  PathCollector collector{mesh(), prepared_->copy, out};
  const Index vertex = mesh().vertex_at(point);
  const auto [face, b] = location_of(vertex != no_index ? point : best_near(point).asked);
  ask_cgal([&] {
    return vertex != no_index ? paths_.shortest_path_sequence_to_source_points(Vertex(vertex), collector)
                              : paths_.shortest_path_sequence_to_source_points(face, b, collector);
  });
  out.front() = point;
  out.back() = source_;
  require_length(out, at(point));
}

/// CGAL traces wrong ways through faces without area that lie in a row.
void SourceTree::require_length(const std::vector<SurfacePoint>& path, double distance) const {
  constexpr double rounding = 1e-9;  // of coordinates, too
  double length = 0, size = distance;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vec3 p = mesh().position(path[i]);
    size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    if (i > 0) length += geodrome::distance(p, mesh().position(path[i - 1]));
  }
  if (std::abs(length - distance) > rounding * size)
    throw NumericalError(
        "CGAL's path has length " + std::to_string(length) + ", its distance is " + std::to_string(distance),
        "choose another exact solver, or remove faces without area");
}

}  // namespace geodrome::cgal
