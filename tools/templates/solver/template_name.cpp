// A solver to start from: shortest paths along the edges of the mesh, after Dijkstra (1959), then straight to a point
// of a face; without a stated factor. The solver kit keeps targets, checks requests and packs the mesh. Replace
// `search`, `distance_at` and `trace` by your method, then state what it provides.
#include <algorithm>
#include <cmath>
#include <geodrome/plugin.hpp>
#include <geodrome/solver_kit/indexed_heap.hpp>
#include <geodrome/solver_kit/kept_search.hpp>
#include <geodrome/solver_kit/packed_mesh.hpp>
#include <memory>
#include <utility>
#include <vector>

using namespace geodrome;

namespace {

/// One per thread: owns its buffers and is used again and again.
class TemplateNameSearch final : public KeptSearch {
 public:
  explicit TemplateNameSearch(std::shared_ptr<const PackedMesh> surface)
      : KeptSearch(surface->mesh(), surface->components()),
        surface_(std::move(surface)),
        distance_(surface_->vertex_count()),
        before_(distance_.size()),
        source_(distance_.size()),
        queue_(distance_.size()) {}

 private:
  std::span<const double> vertices() const override { return distance_; }
  std::span<const Counter> counters() const override { return {}; }

  void refuse(std::span<const Source> sources, const Request&) const override {
    for (const Source& source : sources)
      if (mesh().vertex_at(source.at) == no_index) throw CapabilityError("sources must be vertices");
  }

  void search(const Request&, RunContext& context) override {
    std::fill(distance_.begin(), distance_.end(), infinity);
    queue_.clear();  // a run that was cancelled has left its own
    for (Index i = 0; i < sources().size(); ++i)
      reach(mesh().vertex_at(sources()[i].at), sources()[i].start, no_index, i);
    while (!queue_.empty()) {
      context.throw_if_cancelled();
      const Index vertex = queue_.pop();
      for (const Index h : surface_->corners(surface_->vertex_of_original(vertex))) {
        const Index last = SurfaceMesh::previous(h);
        reach_along(vertex, SurfaceMesh::next(h), surface_->length(h));
        reach_along(vertex, last, surface_->length(last));
      }
    }
  }

  /// To the vertex at which half-edge `to` starts; `length` is in the packed mesh's units.
  void reach_along(Index vertex, Index to, double length) {
    reach(surface_->original_vertex(surface_->from(to)), distance_[vertex] + std::ldexp(length, -surface_->exponent()),
          vertex, source_[vertex]);
  }

  void reach(Index vertex, double distance, Index before, Index source) {
    if (distance >= distance_[vertex] || distance > radius()) return;
    distance_[vertex] = distance, before_[vertex] = before, source_[vertex] = source;
    queue_.push(vertex, distance);
  }

  /// The vertex itself, or the corner over which the path is shortest, and the distance.
  std::pair<Index, double> last_vertex(const SurfacePoint& point) const {
    const Index vertex = mesh().vertex_at(point);
    if (vertex != no_index) return {vertex, distance_[vertex]};
    std::pair<Index, double> best{no_index, infinity};
    surface_->for_each_name(surface_->inner(point), [&](const SurfacePoint& name) {
      for (Index h = 3 * name.face; h < 3 * name.face + 3; ++h) {
        const auto [x, y] = surface_->in_frame(h, name.b);
        const Index corner = surface_->original_vertex(surface_->from(h));
        const double distance = distance_[corner] + std::ldexp(std::hypot(x, y), -surface_->exponent());
        if (distance < best.second) best = {corner, distance};
      }
    });
    return best;
  }

  Distance distance_at(const SurfacePoint& point) const override {
    const auto [vertex, distance] = last_vertex(point);
    if (!(distance <= radius()) || distance == infinity) return no_distance(point.face);
    return {distance, Reach::reached, source_[vertex]};
  }

  void trace(const SurfacePoint& point, const Distance&, std::vector<SurfacePoint>& out) const override {
    out.push_back(point);
    for (Index v = last_vertex(point).first; v != no_index; v = before_[v])
      if (v != mesh().vertex_at(point)) out.push_back(mesh().at_vertex(v));
  }

  std::shared_ptr<const PackedMesh> surface_;
  std::vector<double> distance_;
  std::vector<Index> before_, source_;
  IndexedHeap queue_;
};

/// Immutable, shared by all threads: whatever is computed once per mesh belongs here.
class TemplateNameSurface : public PreparedSurface {
 public:
  explicit TemplateNameSurface(MeshPtr mesh) : surface_(std::make_shared<const PackedMesh>(std::move(mesh))) {}
  std::unique_ptr<Search> make_search() const override { return std::make_unique<TemplateNameSearch>(surface_); }
  std::size_t bytes() const override { return surface_->bytes(); }

 private:
  std::shared_ptr<const PackedMesh> surface_;
};

class TemplateName : public ShortestPathSolver {
 public:
  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext&) const override {
    require_unweighted(*mesh);
    return std::make_unique<TemplateNameSurface>(std::move(mesh));
  }
};

}  // namespace

GEODROME_PLUGIN(TemplateName, .name = "template_name", .summary = "shortest paths along edges (Dijkstra 1959)",
                .licence = "MIT",
                .provides = Provides::start_distances | Provides::radius_limit | Provides::any_point | Provides::paths |
                            Provides::path_is_distance)
