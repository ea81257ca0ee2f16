// SPDX-License-Identifier: MIT
// A whole solver plugin: shortest paths along the edges of the mesh, after Dijkstra (1959).
#include <geodrome/plugin.hpp>
#include <queue>

using namespace geodrome;

namespace {

class EdgeSearch : public Search, public ShortestPathMap {
 public:
  explicit EdgeSearch(MeshPtr mesh) : mesh_(std::move(mesh)), edges_(mesh_->vertex_count()) {
    for (Index h = 0; h < 3 * mesh_->face_count(); ++h) {
      edges_[mesh_->from(h)].push_back(mesh_->to(h));
      edges_[mesh_->to(h)].push_back(mesh_->from(h));
    }
  }

  const ShortestPathMap& run(std::span<const Source> sources, const Request&, RunContext& context) override {
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    distance_.assign(mesh_->vertex_count(), std::numeric_limits<double>::infinity());
    const auto reach = [&](Index vertex, double distance) {
      if (distance >= distance_[vertex]) return;
      distance_[vertex] = distance;
      queue.emplace(distance, vertex);
    };
    for (const Source& source : sources) reach(mesh_->vertex_at(source.at), source.start);
    while (!queue.empty()) {
      context.throw_if_cancelled();
      const auto [distance, vertex] = queue.top();
      queue.pop();
      if (distance > distance_[vertex]) continue;
      for (const Index to : edges_[vertex])
        reach(to, distance + geodrome::distance(mesh_->positions()[vertex], mesh_->positions()[to]));
    }
    return *this;
  }

  std::span<const double> vertices() const override { return distance_; }
  Distance at(const SurfacePoint& point) const override {
    const Index vertex = mesh_->vertex_at(point);
    if (vertex == no_index) throw CapabilityError("only distances of vertices are known");
    const bool reached = std::isfinite(distance_[vertex]);
    return {distance_[vertex], reached ? Reach::reached : Reach::unreachable, reached ? 0 : no_index};
  }
  void path(const SurfacePoint&, std::vector<SurfacePoint>&) const override {
    throw CapabilityError("paths are not kept");
  }
  std::span<const Counter> counters() const override { return {}; }

 private:
  MeshPtr mesh_;
  std::vector<std::vector<Index>> edges_;
  std::vector<double> distance_;
};

class EdgeSurface : public PreparedSurface {
 public:
  explicit EdgeSurface(MeshPtr mesh) : mesh_(std::move(mesh)) {}
  std::unique_ptr<Search> make_search() const override { return std::make_unique<EdgeSearch>(mesh_); }
  std::size_t bytes() const override { return 0; }

 private:
  MeshPtr mesh_;
};

class EdgeSolver : public ShortestPathSolver {
 public:
  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext&) const override {
    return std::make_unique<EdgeSurface>(std::move(mesh));
  }
};

}  // namespace

GEODROME_PLUGIN(EdgeSolver, .name = "third_party", .summary = "shortest paths along edges (Dijkstra 1959)",
                .licence = "MIT", .provides = start_distances | never_shorter)
