// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/matrix_rows.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <future>
#include <mutex>
#include <numeric>
#include <ostream>
#include <thread>

#include "engine/report/median.hpp"
#include "geodrome/many_searches.hpp"
#include "tools/bench/solvers/runner.hpp"

namespace geodrome::bench {
namespace {

using Rows = std::vector<std::vector<double>>;

/// Processor time that a piece of work takes of all threads of this process.
template <class Work>
double seconds_of_all_threads(Work&& work) {
  return processor_seconds_of(work, CLOCK_PROCESS_CPUTIME_ID);
}

class PlanContext final : public QuietContext {
 public:
  explicit PlanContext(unsigned threads) : threads_(threads) {}
  unsigned threads() const noexcept override { return threads_; }
  void measure(std::string_view name, double value) override {
    const std::lock_guard lock(mutex_);
    measures_[std::string(name)] = value;
  }
  const std::map<std::string, double>& measures() const { return measures_; }

 private:
  unsigned threads_;
  std::mutex mutex_;
  std::map<std::string, double> measures_;
};

std::vector<Index> vertices_on_faces(const SurfaceMesh& mesh) {
  std::vector<Index> vertices;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.first_half_edge(v) != no_index) vertices.push_back(v);
  return vertices;
}

/// Ascending, as a job makes them, each once.
std::vector<Index> choose_rows(const SurfaceMesh& mesh, const MatrixRowsOptions& options) {
  if (options.rows == 0) return vertices_on_faces(mesh);
  std::vector<Index> rows = choose_sources(mesh, options.rows, options.seed);
  std::ranges::sort(rows);
  rows.erase(std::ranges::unique(rows).begin(), rows.end());
  return rows;
}

/// One of the two, with a search a thread.
class RowsOf {
 public:
  RowsOf(const Plugin<ShortestPathSolver>& plugin, const MeshPtr& mesh, double radius, unsigned threads)
      : plugin_(plugin), mesh_(*mesh), radius_(radius), threads_(threads) {
    require_needs(plugin.info, *mesh);
    lane.name = plugin.info.full_name();
    PlanContext context(threads);
    timed([&] { prepared_ = plugin_.call([&](const auto& solver) { return solver.prepare(mesh, context); }); });
    lane.bytes = prepared_->bytes();
  }

  /// Returns whether the solver found that it pays.
  bool plan(const std::vector<SurfacePoint>& sources, PlanContext& context) {
    const auto* table = plugin_.extension<ManySearches>();
    if (!table) throw CapabilityError(plugin_.info.full_name() + " does not prepare searches together");
    timed([&] {
      planned_ = plugin_.call([&](const auto&) { return table->prepare(*prepared_, {sources, radius_}, context); });
    });
    if (planned_) lane.bytes = planned_->bytes();
    return planned_ != nullptr;
  }

  void make_searches(Index first) {
    const PreparedSurface& surface = planned_ ? *planned_ : *prepared_;
    for (unsigned k = 0; k < threads_; ++k)
      searches_.push_back(plugin_.call([&](const auto&) { return surface.make_search(); }));
    std::vector<double> row;
    for (const auto& search : searches_) make_row(*search, first, row);
  }

  void make_chunk(std::span<const Index> sources, Rows& rows) {
    rows.resize(sources.size());
    lane.chunk.push_back(seconds_of_all_threads([&] {
      std::atomic<std::size_t> next = 0;
      const auto work = [&](Search& search) {
        for (std::size_t i = next++; i < sources.size(); i = next++) make_row(search, sources[i], rows[i]);
      };
      std::vector<std::future<void>> others;
      for (std::size_t k = 1; k < searches_.size(); ++k)
        others.push_back(std::async(std::launch::async, [&, k] { work(*searches_[k]); }));
      work(*searches_[0]);
      for (auto& other : others) other.get();
    }));
  }

  MatrixLane lane;

 private:
  template <class Work>
  void timed(Work&& work) {
    lane.preparation_by_clock += seconds_of([&] { lane.preparation += seconds_of_all_threads(work); });
  }

  void make_row(Search& search, Index vertex, std::vector<double>& row) const {
    QuietContext context;
    const Source source{mesh_.at_vertex(vertex), 0};
    plugin_.call([&](const auto&) {
      const auto values = search.run({&source, 1}, {.radius = radius_}, context).vertices();
      row.assign(values.begin(), values.end());
    });
  }

  const Plugin<ShortestPathSolver>& plugin_;
  const SurfaceMesh& mesh_;
  double radius_;
  unsigned threads_;
  std::unique_ptr<PreparedSurface> prepared_, planned_;  // the second goes first: it may refer to the other
  std::vector<std::unique_ptr<Search>> searches_;
};

double largest_of(std::span<const double> row) {
  double largest = 0;
  for (const double value : row)
    if (std::isfinite(value)) largest = std::max(largest, value);
  return largest;
}

/// Of two distances over the largest one; what one of them has beyond the radius is no difference if the other lies on
/// it.
double apart(double a, double b, double largest, double radius) {
  if (a == b) return 0;
  if (std::isfinite(a) && std::isfinite(b)) return largest > 0 ? std::abs(a - b) / largest : std::abs(a - b);
  return std::min(a, b) >= radius * (1 - 1e-12) ? 0 : infinity;
}

/// Holds the distances from each row's source to those of later rows until these are made.
class RowJudge {
 public:
  RowJudge(std::span<const Index> sources, double radius, MatrixRowsResult& result)
      : sources_(sources), radius_(radius), result_(result) {}

  void hear(const std::vector<double>& row, const std::vector<double>& plain) {
    const double largest = largest_of(plain);
    for (std::size_t v = 0; v < row.size(); ++v)
      result_.worst_difference = std::max(result_.worst_difference, apart(row[v], plain[v], largest, radius_));
    const std::size_t i = later_.size();
    for (std::size_t j = 0; j < i; ++j)
      result_.worst_asymmetry =
          std::max(result_.worst_asymmetry, apart(row[sources_[j]], later_[j][i - j - 1], largest, radius_));
    later_.emplace_back();
    for (std::size_t j = i + 1; j < sources_.size(); ++j) later_.back().push_back(row[sources_[j]]);
  }

 private:
  std::span<const Index> sources_;
  double radius_;
  MatrixRowsResult& result_;
  Rows later_;
};

std::vector<double> ratios(const MatrixRowsResult& result) {
  std::vector<double> ratio;
  for (std::size_t i = 0; i < result.peer.chunk.size(); ++i)
    ratio.push_back(result.solver.chunk[i] / result.peer.chunk[i]);
  return ratio;
}

double row_seconds(const MatrixLane& lane, std::size_t rows) {
  return std::accumulate(lane.chunk.begin(), lane.chunk.end(), 0.0) / static_cast<double>(rows);
}

void print_lane(std::ostream& out, const MatrixLane& lane, const MatrixRowsResult& result) {
  char text[300];
  std::snprintf(text, sizeof text,
                "%-24s prepared in %10.4f s (%.4f s by the clock), %9.2f MB; a row %10.6f s; whole matrix %10.2f s\n",
                lane.name.c_str(), lane.preparation, lane.preparation_by_clock, static_cast<double>(lane.bytes) * 1e-6,
                row_seconds(lane, result.rows), whole_matrix(lane, result));
  out << text;
}

}  // namespace

MatrixRowsResult matrix_rows(const Plugin<ShortestPathSolver>& solver, const Plugin<ShortestPathSolver>& peer,
                             const MeshPtr& mesh, const MatrixRowsOptions& options) {
  const unsigned threads = options.threads ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  const std::vector<Index> sources = choose_rows(*mesh, options), all = vertices_on_faces(*mesh);
  RowsOf first(solver, mesh, options.radius, threads), second(peer, mesh, options.radius, threads);
  PlanContext context(threads);
  std::vector<SurfacePoint> plan;
  for (const Index v : options.of_rows_alone ? sources : all) plan.push_back(mesh->at_vertex(v));
  MatrixRowsResult result{.used = first.plan(plan, context), .vertices = all.size(), .rows = sources.size()};
  result.measures = context.measures();
  first.make_searches(sources[0]), second.make_searches(sources[0]);
  RowJudge judge(sources, options.radius, result);
  Rows rows, plain;
  bool turn = false;
  for (std::size_t begin = 0; begin < sources.size(); begin += options.chunk, turn = !turn) {
    const auto chunk = std::span(sources).subspan(begin, std::min(options.chunk, sources.size() - begin));
    if (turn) second.make_chunk(chunk, plain);
    first.make_chunk(chunk, rows);
    if (!turn) second.make_chunk(chunk, plain);
    for (std::size_t i = 0; i < chunk.size(); ++i) judge.hear(rows[i], plain[i]);
  }
  result.solver = first.lane, result.peer = second.lane;
  return result;
}

double whole_matrix(const MatrixLane& lane, const MatrixRowsResult& result) {
  return lane.preparation + static_cast<double>(result.vertices) * row_seconds(lane, result.rows);
}

void print(std::ostream& out, const MatrixRowsResult& result) {
  out << (result.used ? "searches prepared together:" : "to prepare searches together would not pay:");
  for (const auto& [name, value] : result.measures) out << ' ' << name << ' ' << value;
  out << '\n';
  print_lane(out, result.solver, result);
  print_lane(out, result.peer, result);
  const std::vector<double> ratio = ratios(result);
  const auto [least, most] = std::minmax_element(ratio.begin(), ratio.end());
  char text[300];
  std::snprintf(text, sizeof text,
                "solver / peer: row %.3f (median of %zu chunks; %.3f to %.3f), whole matrix %.3f\n"
                "over %zu rows: largest difference %.3g, asymmetry %.3g of the largest distance\n",
                median(ratio), ratio.size(), *least, *most,
                whole_matrix(result.solver, result) / whole_matrix(result.peer, result), result.rows,
                result.worst_difference, result.worst_asymmetry);
  out << text;
}

}  // namespace geodrome::bench
