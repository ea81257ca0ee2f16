// A solver to start from: shortest paths along the edges of the mesh, after Dijkstra (1959). Never shorter than the
// true distance, without a stated factor. Replace what is between prepare and at by your method, then state what it
// provides.
#include <geodrome/plugin.hpp>
#include <queue>

using namespace geodrome;

namespace {

/// Immutable, shared by all threads: whatever is computed once per mesh belongs here.
struct Graph {
  explicit Graph(MeshPtr surface) : mesh(std::move(surface)), neighbours(mesh->vertex_count()) {
    for (Index h = 0; h < 3 * mesh->face_count(); ++h) {
      neighbours[mesh->from(h)].push_back(mesh->to(h));
      neighbours[mesh->to(h)].push_back(mesh->from(h));
    }
  }

  double length(Index a, Index b) const { return distance(mesh->positions()[a], mesh->positions()[b]); }

  MeshPtr mesh;
  std::vector<std::vector<Index>> neighbours;
};

/// One per thread: owns its buffers, is used again and again, and is its own result.
class TemplateNameSearch : public Search, public ShortestPathMap {
 public:
  explicit TemplateNameSearch(std::shared_ptr<const Graph> graph) : graph_(std::move(graph)) {}

  const ShortestPathMap& run(std::span<const Source> sources, const Request&, RunContext& context) override {
    if (sources.empty()) throw InputError(InputFault::empty, "no source");
    distance_.assign(graph_->mesh->vertex_count(), infinity);
    before_.assign(distance_.size(), no_index);
    source_.assign(distance_.size(), no_index);
    queue_ = {};  // a run that was cancelled has left its own
    for (Index i = 0; i < sources.size(); ++i) reach(vertex_of(sources[i].at), sources[i].start, no_index, i);
    while (!queue_.empty()) {
      context.throw_if_cancelled();
      const auto [distance, vertex] = queue_.top();
      queue_.pop();
      if (distance > distance_[vertex]) continue;  // reached on a shorter way since
      for (const Index to : graph_->neighbours[vertex])
        reach(to, distance + graph_->length(vertex, to), vertex, source_[vertex]);
    }
    return *this;
  }

  std::span<const double> vertices() const override { return distance_; }

  Distance at(const SurfacePoint& point) const override {
    const Index v = vertex_of(point);
    return {distance_[v], distance_[v] < infinity ? Reach::reached : Reach::unreachable, source_[v]};
  }

  void path(const SurfacePoint& point, std::vector<SurfacePoint>& out) const override {
    out.clear();
    Index v = vertex_of(point);
    if (distance_[v] == infinity) return;
    for (; v != no_index; v = before_[v]) out.push_back(out.empty() ? point : graph_->mesh->at_vertex(v));
  }

  std::span<const Counter> counters() const override { return {}; }

 private:
  void reach(Index vertex, double distance, Index before, Index source) {
    if (distance >= distance_[vertex]) return;
    distance_[vertex] = distance, before_[vertex] = before, source_[vertex] = source;
    queue_.emplace(distance, vertex);
  }

  /// What the descriptor does not provide is refused, never guessed.
  Index vertex_of(const SurfacePoint& point) const {
    const Index vertex = point.face < graph_->mesh->face_count() ? graph_->mesh->vertex_at(point) : no_index;
    if (vertex == no_index) throw CapabilityError("only distances of vertices are known");
    return vertex;
  }

  using Entry = std::pair<double, Index>;
  std::shared_ptr<const Graph> graph_;
  std::vector<double> distance_;
  std::vector<Index> before_, source_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

class TemplateNameSurface : public PreparedSurface {
 public:
  explicit TemplateNameSurface(MeshPtr mesh) : graph_(std::make_shared<const Graph>(std::move(mesh))) {}

  std::unique_ptr<Search> make_search() const override { return std::make_unique<TemplateNameSearch>(graph_); }
  std::size_t bytes() const override {
    return graph_->neighbours.size() * sizeof(std::vector<Index>) + 6 * graph_->mesh->face_count() * sizeof(Index);
  }

 private:
  std::shared_ptr<const Graph> graph_;
};

class TemplateName : public ShortestPathSolver {
 public:
  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext&) const override {
    return std::make_unique<TemplateNameSurface>(std::move(mesh));
  }
};

}  // namespace

GEODROME_PLUGIN(TemplateName, .name = "template_name", .summary = "shortest paths along edges (Dijkstra 1959)",
                .licence = "MIT",
                .provides = Provides::start_distances | Provides::paths | Provides::path_is_distance |
                            Provides::never_shorter)
