// SPDX-License-Identifier: MIT
// A good one: the shortest ways along edges of a mesh with weights, where an edge costs its length times the smallest
// weight of its faces. Works on vertices alone, in O(V E), for small meshes.
#include <algorithm>
#include <map>

#include "geodrome/plugin.hpp"

namespace geodrome {
namespace {

/// What it costs to go along an edge, per pair of vertices, in both directions.
using Edges = std::map<std::pair<Index, Index>, double>;

Edges edges_of(const SurfaceMesh& mesh) {
  Edges edges;
  for (Index h = 0; h < 3 * mesh.face_count(); ++h) {
    const double weight = mesh.face_weights().empty() ? 1 : mesh.face_weights()[SurfaceMesh::face(h)];
    const Index a = mesh.from(h), b = mesh.to(h);
    const double cost = weight * distance(mesh.positions()[a], mesh.positions()[b]);
    for (const auto& edge : {std::pair(a, b), std::pair(b, a)}) {
      const auto known = edges.emplace(edge, cost).first;
      known->second = std::min(known->second, cost);
    }
  }
  return edges;
}

class WeightedSearch : public Search, public ShortestPathMap {
 public:
  explicit WeightedSearch(MeshPtr mesh) : mesh_(std::move(mesh)), edges_(edges_of(*mesh_)) {}

  const ShortestPathMap& run(std::span<const Source> sources, const Request&, RunContext&) override {
    values_.assign(mesh_->vertex_count(), infinity);
    before_.assign(mesh_->vertex_count(), no_index);
    for (const Source& source : sources) values_[vertex_of(source.at)] = source.start;
    // As many rounds as a path may have edges (Bellman and Ford): nothing to get wrong.
    for (bool changed = true; changed;) {
      changed = false;
      for (const auto& [edge, cost] : edges_) {
        if (!(values_[edge.first] + cost < values_[edge.second])) continue;
        values_[edge.second] = values_[edge.first] + cost, before_[edge.second] = edge.first;
        changed = true;
      }
    }
    return *this;
  }

  std::span<const double> vertices() const override { return values_; }
  Distance at(const SurfacePoint& point) const override {
    const double value = values_[vertex_of(point)];
    return value == infinity ? Distance{} : Distance{value, Reach::reached, 0};
  }
  void path(const SurfacePoint& point, std::vector<SurfacePoint>& out) const override {
    out.clear();
    for (Index v = vertex_of(point); v != no_index; v = before_[v]) out.push_back(mesh_->at_vertex(v));
  }
  std::span<const Counter> counters() const override { return {}; }

 private:
  Index vertex_of(const SurfacePoint& point) const {
    const Index vertex = mesh_->vertex_at(point);
    if (vertex == no_index) throw CapabilityError("only vertices can be asked");
    return vertex;
  }

  MeshPtr mesh_;
  Edges edges_;
  std::vector<double> values_;
  std::vector<Index> before_;
};

class WeightedSurface : public PreparedSurface {
 public:
  explicit WeightedSurface(MeshPtr mesh) : mesh_(std::move(mesh)) {}
  std::unique_ptr<Search> make_search() const override { return std::make_unique<WeightedSearch>(mesh_); }
  std::size_t bytes() const override { return 0; }

 private:
  MeshPtr mesh_;
};

class WeightedSolver : public ShortestPathSolver {
 public:
  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext&) const override {
    return std::make_unique<WeightedSurface>(std::move(mesh));
  }
};

}  // namespace
}  // namespace geodrome

GEODROME_PLUGIN(geodrome::WeightedSolver, .name = "test_weighted", .summary = "along edges, weighted", .licence = "MIT",
                .provides = geodrome::Provides::weights | geodrome::Provides::paths |
                            geodrome::Provides::path_is_distance | geodrome::Provides::never_shorter,
                .factor = geodrome::no_factor)
