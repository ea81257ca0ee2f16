// SPDX-License-Identifier: MIT
#include "plugins/solver_edge_dijkstra/edge_dijkstra.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "geodrome/solver_kit/kept_search.hpp"
#include "geodrome/vertex_components.hpp"
#include "plugins/solver_edge_dijkstra/edge_graph.hpp"
#include "plugins/solver_edge_dijkstra/label_search.hpp"

namespace geodrome {
namespace {

struct Prepared {
  MeshPtr mesh;
  EdgeGraph graph;
  std::vector<Index> component;

  explicit Prepared(MeshPtr input) : mesh(std::move(input)), graph(*mesh), component(vertex_components(*mesh)) {}

  /// The length of the straight way from a point to a corner of a face that holds both; in differences of coordinates,
  /// so that it is exact far from the origin too.
  double to_corner(const SurfacePoint& point, Index vertex) const {
    const Vec3 target = mesh->positions()[vertex];
    const auto corners = mesh->corners(point.face);
    Vec3 way;
    for (int i = 0; i < 3; ++i) way = way + point.b[i] * (corners[i] - target);
    return std::hypot(way.x, way.y, way.z);
  }

  /// Calls `visit(face)` for every face that holds `point`, which is no vertex: its own, or all faces of its edge.
  template <class Visit>
  void faces_at(const SurfacePoint& point, Visit&& visit) const {
    visit(point.face);
    for (Index i = 0; i < 3; ++i) {
      if (point.b[i] != 0) continue;
      const Index edge = 3 * point.face + (i + 1) % 3;
      for (Index h = graph.next_on_edge(edge); h != edge; h = graph.next_on_edge(h)) visit(SurfaceMesh::face(h));
    }
  }

  /// The straight way between two points that a common face holds. Both are seen from a corner of a's face, which is in
  /// b's face too where the common face is not a's own.
  double between(const SurfacePoint& a, const SurfacePoint& b) const {
    const Vec3 origin = mesh->positions()[mesh->triangles()[a.face][0]];
    const auto seen = [&](const SurfacePoint& p) {
      const auto corners = mesh->corners(p.face);
      Vec3 sum;
      for (int i = 0; i < 3; ++i) sum = sum + p.b[i] * (corners[i] - origin);
      return sum;
    };
    return segment_length(seen(a), seen(b));
  }
};

/// The best way found to a point: from the source straight, or through a corner.
struct Way {
  double value = infinity;
  Index source = no_index, corner = no_index;

  void improve(double other, Index other_source, Index other_corner) {
    if (other < value || (other == value && other_source < source)) *this = {other, other_source, other_corner};
  }
};

class EdgeSearch final : public KeptSearch {
 public:
  explicit EdgeSearch(std::shared_ptr<const Prepared> prepared)
      : KeptSearch(*prepared->mesh, prepared->component), prepared_(std::move(prepared)), labels_(prepared_->graph) {}

 private:
  std::span<const double> vertices() const override { return labels_.distances(); }
  std::span<const Counter> counters() const override { return counters_; }

  void search(const Request& request, RunContext& context) override {
    labels_.clear();
    seed();
    if (request.stop_at_targets)
      for (const SurfacePoint& target : request.targets) want(target);
    labels_.run(radius(), request.stop_at_targets, context);
    counters_[0].value = labels_.settled();
  }

  Distance distance_at(const SurfacePoint& point) const override {
    const Way way = way_to(point);
    if (way.value <= radius() && way.source != no_index && (way.value <= labels_.limit() || corners_settled(point)))
      return {way.value, Reach::reached, way.source};
    return no_distance(point.face);
  }

  void trace(const SurfacePoint& point, const Distance&, std::vector<SurfacePoint>& out) const override {
    const Way way = way_to(point);
    const SurfacePoint& source = sources()[way.source].at;
    out.push_back(point);
    const Index start = mesh().vertex_at(point), end = mesh().vertex_at(source);
    for (Index v = way.corner; v != no_index; v = labels_.previous(v))
      if (v != start && v != end) out.push_back(mesh().at_vertex(v));
    if (start == no_index || start != end) out.push_back(source);
  }

  void seed() {
    sources_in_face_.clear();
    for (Index i = 0; i < sources().size(); ++i) {
      const auto& [at, start] = sources()[i];
      const Index vertex = mesh().vertex_at(at);
      if (vertex != no_index) {
        labels_.seed(vertex, start, i);
        continue;
      }
      prepared_->faces_at(at, [&, i, start = start](Index face) {
        for (const Index corner : mesh().triangles()[face])
          labels_.seed(corner, start + prepared_->to_corner(at, corner), i);
        sources_in_face_.emplace_back(face, i);
      });
    }
    std::sort(sources_in_face_.begin(), sources_in_face_.end());
  }

  void want(const SurfacePoint& target) {
    const Index vertex = mesh().vertex_at(target);
    if (vertex != no_index) return labels_.want(vertex);
    prepared_->faces_at(target, [&](Index face) {
      for (const Index corner : mesh().triangles()[face]) labels_.want(corner);
    });
  }

  /// The best way through settled vertices or straight from a source. It is the shortest if all corners are settled, or
  /// if it is not longer than the search went: a way through a vertex that is not settled would be longer.
  Way way_to(const SurfacePoint& point) const {
    Way way;
    const Index vertex = mesh().vertex_at(point);
    if (vertex != no_index) {
      way.improve(labels_.distances()[vertex], labels_.source(vertex), vertex);
      return way;
    }
    prepared_->faces_at(point, [&](Index face) {
      for (const Index corner : mesh().triangles()[face])
        if (labels_.source(corner) != no_index)
          way.improve(labels_.distances()[corner] + prepared_->to_corner(point, corner), labels_.source(corner),
                      corner);
      const std::pair<Index, Index> from{face, 0};
      for (auto s = std::lower_bound(sources_in_face_.begin(), sources_in_face_.end(), from);
           s != sources_in_face_.end() && s->first == face; ++s)
        way.improve(sources()[s->second].start + prepared_->between(point, sources()[s->second].at), s->second,
                    no_index);
    });
    return way;
  }

  bool corners_settled(const SurfacePoint& point) const {
    bool settled = true;
    prepared_->faces_at(point, [&](Index face) {
      for (const Index corner : mesh().triangles()[face]) settled = settled && labels_.source(corner) != no_index;
    });
    return settled;
  }

  std::shared_ptr<const Prepared> prepared_;
  LabelSearch labels_;
  std::vector<std::pair<Index, Index>> sources_in_face_;  // (face, source), of sources that are no vertices
  std::array<Counter, 1> counters_{{{"settled_vertices", 0}}};
};

class EdgePrepared final : public PreparedSurface {
 public:
  explicit EdgePrepared(MeshPtr mesh) : prepared_(std::make_shared<const Prepared>(std::move(mesh))) {}
  std::unique_ptr<Search> make_search() const override { return std::make_unique<EdgeSearch>(prepared_); }
  std::size_t bytes() const override { return prepared_->graph.bytes() + prepared_->component.size() * sizeof(Index); }

 private:
  std::shared_ptr<const Prepared> prepared_;
};

}  // namespace

std::unique_ptr<PreparedSurface> EdgeDijkstra::prepare(MeshPtr mesh, RunContext& context) const {
  context.throw_if_cancelled();
  require_unweighted(*mesh);
  return std::make_unique<EdgePrepared>(std::move(mesh));
}

}  // namespace geodrome
