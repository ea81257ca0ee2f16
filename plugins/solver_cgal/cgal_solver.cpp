// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/solver_cgal/cgal_solver.hpp"

#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/assertions_behaviour.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <unordered_map>

#include "geodrome/solver_kit/kept_search.hpp"
#include "geodrome/vertex_components.hpp"
#include "plugins/common_gpl/guarded.hpp"
#include "plugins/solver_cgal/cgal_surface.hpp"

namespace geodrome {
namespace {

using cgal::LayoutTraits;
using cgal::Mesh;
using ShortestPaths = CGAL::Surface_mesh_shortest_path<LayoutTraits>;
using FaceLocation = ShortestPaths::Face_location;

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

struct Prepared {
  MeshPtr mesh;
  cgal::Normalisation normalisation;
  Mesh copy;
  std::vector<Index> component;

  explicit Prepared(MeshPtr input)
      : mesh(std::move(input)),
        normalisation(*mesh),
        copy(cgal::copy_for_cgal(*mesh, normalisation)),
        component(vertex_components(*mesh)) {}
};

FaceLocation location_of(const SurfacePoint& p) {
  return {Mesh::Face_index(p.face), LayoutTraits::Barycentric_coordinates{p.b[0], p.b[1], p.b[2]}};
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

class CgalSearch final : public KeptSearch {
 public:
  explicit CgalSearch(std::shared_ptr<const Prepared> prepared)
      : KeptSearch(*prepared->mesh, prepared->component),
        prepared_(std::move(prepared)),
        distances_(prepared_->mesh->vertex_count()),
        at_vertex_(distances_.size()) {
    reset();
  }

 private:
  std::span<const double> vertices() const override { return distances_; }
  std::span<const Counter> counters() const override { return {}; }

  void refuse(std::span<const Source> sources, const Request& request) const override {
    for (const Source& source : sources)
      if (source.start != 0) throw CapabilityError("sources with a start distance are not supported");
    if (request.stop_at_targets) throw CapabilityError("stopping at targets is not supported");
  }

  void search(const Request&, RunContext& context) override {
    build(context);
    for (Index v = 0; v < distances_.size(); ++v) {
      at_vertex_[v] = on_vertex(v);
      distances_[v] = at_vertex_[v].value;
    }
  }

  void finish() override {
    if (keep() == Keep::targets) reset();
  }

  Distance distance_at(const SurfacePoint& point) const override {
    const Index vertex = mesh().vertex_at(point);
    return vertex != no_index ? at_vertex_[vertex] : inside(point);
  }

  void trace(const SurfacePoint& point, const Distance& distance, std::vector<SurfacePoint>& out) const override {
    PathCollector collector{mesh(), prepared_->copy, out};
    const Index vertex = mesh().vertex_at(point);
    const auto [face, b] = location_of(vertex != no_index ? point : best_near(point).asked);
    ask_cgal([&] {
      return vertex != no_index ? paths_->shortest_path_sequence_to_source_points(Mesh::Vertex_index(vertex), collector)
                                : paths_->shortest_path_sequence_to_source_points(face, b, collector);
    });
    out.front() = point;
    out.back() = sources()[distance.source].at;
    require_length(out, distance.value);
  }

  /// CGAL traces wrong ways through faces without area that lie in a row.
  void require_length(const std::vector<SurfacePoint>& path, double distance) const {
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

  using Found = ShortestPaths::Shortest_path_result;
  using Vertex = Mesh::Vertex_index;
  struct Best {
    Found found;
    SurfacePoint asked;
  };

  void reset() {
    index_of_source_.clear();
    paths_.emplace(prepared_->copy, LayoutTraits(&poll_));
  }

  /// A search that was cancelled, or in which CGAL failed, starts from a new object: CGAL's own is not exception-safe
  /// (the event in work, some hundred bytes, is lost).
  void build(const RunContext& context) {
    index_of_source_.clear();
    paths_->remove_all_source_points();
    std::set<std::tuple<Index, double, double, double>> places;
    for (Index i = 0; i < sources().size(); ++i) {
      const auto [face, b] = canonical(sources()[i].at);
      if (places.emplace(face, b[0], b[1], b[2]).second) add({face, b}, i);
    }
    poll_.watch(&context);
    try {
      ask_cgal([&] { paths_->build_sequence_tree(); });
    } catch (...) {
      poll_.watch(nullptr);
      reset();
      throw;
    }
    poll_.watch(nullptr);
  }

  /// One name for each point: of a point on an edge or at a vertex that in the lowest face. The first source at a place
  /// then hides later ones, so that ties go to the lowest index.
  SurfacePoint canonical(const SurfacePoint& point) const {
    const Index vertex = mesh().vertex_at(point);
    if (vertex != no_index) return mesh().at_vertex(vertex);
    for (Index i = 0; i < 3; ++i) {
      const Index edge = 3 * point.face + (i + 1) % 3, twin = mesh().twins()[edge];
      if (point.b[i] != 0 || twin == no_index || twin > edge) continue;
      SurfacePoint other{SurfaceMesh::face(twin), {}};
      other.b[twin % 3] = point.b[(i + 2) % 3];
      other.b[(twin + 1) % 3] = point.b[(i + 1) % 3];
      return other;
    }
    return point;
  }

  void add(const SurfacePoint& point, Index source) {
    const int zeros = static_cast<int>(std::count(point.b.begin(), point.b.end(), 0.0));
    if (zeros != 1) return add(location_of(point), source);
    const int i = static_cast<int>(std::find(point.b.begin(), point.b.end(), 0.0) - point.b.begin());
    FaceLocation here = location_of(point);
    here.second[i] = just_inside;
    add(here, source);
    const Index edge = 3 * point.face + (i + 1) % 3, twin = mesh().twins()[edge];
    if (twin == no_index) return;
    FaceLocation there{Mesh::Face_index(SurfaceMesh::face(twin)), {just_inside, just_inside, just_inside}};
    there.second[twin % 3] = point.b[(i + 2) % 3];
    there.second[(twin + 1) % 3] = point.b[(i + 1) % 3];
    add(there, source);
  }
  void add(const FaceLocation& location, Index source) {
    index_of_source_.emplace(&*paths_->add_source_point(location), source);
  }

  Distance inside(const SurfacePoint& point) const {
    const Best best = best_near(point);
    return judge(best.found, mesh().triangles()[point.face][0], "a point of face " + std::to_string(point.face));
  }

  /// Windows are closed sets with rounded corners: a point on the common border of two can be in neither, and CGAL then
  /// answers with a third that is far too long. So three points beside it, farther away than the rounding, are asked
  /// too; each gives an upper bound that is as good.
  Best best_near(const SurfacePoint& point) const {
    Best best = ask(point, 0);
    const auto corners = mesh().corners(point.face);
    const Vec3 here = mesh().position(point);
    for (int i = 0; i < 3; ++i) {
      const double side = std::ldexp(distance(corners[i], here), prepared_->normalisation.exponent);
      const Vertex corner(mesh().triangles()[point.face][i]);
      const double reach = std::abs(paths_->shortest_distance_to_source_points(corner).first) + side;
      const double share = side > 0 ? std::min(beside * reach / side, most_beside) : 0;
      SurfacePoint near = point;
      for (double& b : near.b) b *= 1 - share;
      near.b[i] += share;
      const Best other = ask(near, share * side);
      const bool nothing = best.found.second == paths_->source_points_end();
      if (nothing || (other.found.first >= 0 && other.found.first < best.found.first)) best = other;
    }
    return best;
  }
  Best ask(const SurfacePoint& point, double away) const {
    const auto [face, b] = location_of(point);
    Best best{ask_cgal([&] { return paths_->shortest_distance_to_source_points(face, b); }), point};
    if (best.found.first >= 0) best.found.first += away;
    return best;
  }

  Distance on_vertex(Index vertex) const {
    if (mesh().first_half_edge(vertex) == no_index) return {};
    const Found found =
        ask_cgal([&] { return paths_->shortest_distance_to_source_points(Mesh::Vertex_index(vertex)); });
    return judge(found, vertex, "vertex " + std::to_string(vertex));
  }

  /// CGAL says -1 where it found no way. That is right only in a component without a source.
  Distance judge(const Found& found, Index vertex, const std::string& where) const {
    const bool nothing = found.second == paths_->source_points_end();
    if (nothing && !shares_component_with_source(vertex)) return {};
    if (nothing || !(found.first >= 0) || !std::isfinite(found.first))
      throw NumericalError("CGAL found no distance for " + where + ", which can be reached",
                           "check the mesh for needle faces and faces without area, or choose another solver");
    const double value = prepared_->normalisation.original(found.first);
    if (value > radius()) return {infinity, Reach::beyond_limit, no_index};
    return {value, Reach::reached, index_of_source_.at(&*found.second)};
  }

  std::shared_ptr<const Prepared> prepared_;
  cgal::CancelPoll poll_;
  mutable std::optional<ShortestPaths> paths_;  // CGAL's queries are not const: they build the tree on demand
  std::unordered_map<const FaceLocation*, Index> index_of_source_;
  std::vector<double> distances_;
  std::vector<Distance> at_vertex_;
};

class CgalPrepared final : public PreparedSurface {
 public:
  explicit CgalPrepared(MeshPtr mesh) : prepared_(std::make_shared<const Prepared>(std::move(mesh))) {}
  std::unique_ptr<Search> make_search() const override { return std::make_unique<CgalSearch>(prepared_); }

  /// Per vertex a point, a half-edge, a removed flag and a component; per half-edge and face what CGAL's mesh links.
  std::size_t bytes() const override {
    const Mesh& copy = prepared_->copy;
    return copy.number_of_vertices() * (sizeof(cgal::Kernel::Point_3) + 3 * sizeof(Index)) +
           copy.number_of_halfedges() * 4 * sizeof(Index) + copy.number_of_faces() * 2 * sizeof(Index);
  }

 private:
  std::shared_ptr<const Prepared> prepared_;
};

}  // namespace

std::unique_ptr<PreparedSurface> CgalSolver::prepare(MeshPtr mesh, RunContext& context) const {
  context.throw_if_cancelled();
  require_unweighted(*mesh);
  if (!mesh->manifold() || !mesh->oriented()) throw CapabilityError("the mesh must be manifold and oriented");
  CGAL::set_warning_behaviour(CGAL::CONTINUE);
  return ask_cgal([&] { return std::make_unique<CgalPrepared>(std::move(mesh)); });
}

}  // namespace geodrome
