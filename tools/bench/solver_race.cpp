// SPDX-License-Identifier: MIT
#include "tools/bench/solver_race.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ostream>

#include "tools/shapes/random.hpp"

namespace geodrome::bench {
namespace {

template <class Work>
double seconds(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// One solver on the mesh: prepared, with a search, and the distances of the last query.
class Runner {
 public:
  Runner(const Plugin<ShortestPathSolver>& plugin, MeshPtr mesh) : plugin_(plugin), mesh_(std::move(mesh)) {
    const std::string name = plugin.info.full_name();
    const auto demand = [&](std::uint64_t bit, bool given, const char* what) {
      if ((plugin.info.needs & bit) && !given) throw CapabilityError(name + " needs a surface that is " + what);
    };
    demand(Needs::manifold, mesh_->manifold(), "manifold");
    demand(Needs::oriented, mesh_->oriented(), "oriented");
    demand(Needs::closed, mesh_->closed(), "closed");
  }

  double prepare() {
    search_.reset();
    prepared_.reset();
    const double time = seconds([&] {
      prepared_ = plugin_.call([&](const ShortestPathSolver& solver) { return solver.prepare(mesh_, context_); });
    });
    search_ = prepared_->make_search();
    return time;
  }

  double query(Index vertex) {
    const Source source{mesh_->at_vertex(vertex), 0};
    return seconds([&] {
      plugin_.call([&](const ShortestPathSolver&) {
        const auto values = search_->run({&source, 1}, {}, context_).vertices();
        distances_.assign(values.begin(), values.end());
      });
    });
  }

  const std::vector<double>& distances() const { return distances_; }
  std::size_t bytes() const { return prepared_->bytes(); }

 private:
  const Plugin<ShortestPathSolver>& plugin_;
  MeshPtr mesh_;
  QuietContext context_;
  std::unique_ptr<PreparedSurface> prepared_;
  std::unique_ptr<Search> search_;
  std::vector<double> distances_;
};

double worst_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = 0, largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i]) {
      if (std::isfinite(a[i])) largest = std::max(largest, a[i]);
      continue;
    }
    if (!std::isfinite(a[i]) || !std::isfinite(b[i])) return INFINITY;
    worst = std::max(worst, std::abs(a[i] - b[i]));
    largest = std::max({largest, a[i], b[i]});
  }
  return largest > 0 ? worst / largest : worst;
}

/// Vertices that faces use, drawn with the seed; one may come twice.
std::vector<Index> choose_sources(const SurfaceMesh& mesh, const RaceOptions& options) {
  if (mesh.face_count() == 0) throw InputError(InputFault::empty, "the mesh has no face");
  shapes::Random random(options.seed);
  std::vector<Index> sources;
  for (std::size_t i = 0; i < options.sources; ++i)
    sources.push_back(mesh.triangles()[random.index(mesh.face_count())][random.index(3)]);
  return sources;
}

/// All runs from one source; returns how many were void.
std::size_t race_from(Index source, std::size_t runs, Runner& solver, Runner& peer, RaceResult& result) {
  solver.query(source);
  peer.query(source);
  result.worst_difference = std::max(result.worst_difference, worst_difference(solver.distances(), peer.distances()));
  std::vector<double> of_solver, of_peer;
  for (std::size_t run = 0; run < runs; ++run) {
    if (run % 2 == 0) of_solver.push_back(solver.query(source));
    of_peer.push_back(peer.query(source));
    if (run % 2 == 1) of_solver.push_back(solver.query(source));
  }
  constexpr double disturbed = 1.2;
  const double limit = disturbed * median(of_peer);
  auto& valid_solver = result.solver.query.emplace_back();
  auto& valid_peer = result.peer.query.emplace_back();
  for (std::size_t run = 0; run < runs; ++run) {
    if (of_peer[run] > limit) continue;
    valid_solver.push_back(of_solver[run]);
    valid_peer.push_back(of_peer[run]);
  }
  return runs - valid_peer.size();
}

std::vector<double> medians(const std::vector<std::vector<double>>& per_source) {
  std::vector<double> result;
  for (const auto& runs : per_source) result.push_back(median(runs));
  return result;
}

void print_lane(std::ostream& out, const Lane& lane) {
  char line[200];
  std::snprintf(line, sizeof line, "%-24s preparation %10.6f s   query %10.6f s   prepared surface %8.2f MB\n",
                lane.name.c_str(), median(lane.preparation), median(medians(lane.query)),
                static_cast<double>(lane.prepared_bytes) * 1e-6);
  out << line;
}

}  // namespace

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

RaceResult race(const Plugin<ShortestPathSolver>& solver, const Plugin<ShortestPathSolver>& peer, const MeshPtr& mesh,
                const RaceOptions& options) {
  constexpr int preparations = 3;
  const std::vector<Index> sources = choose_sources(*mesh, options);
  Runner first(solver, mesh), second(peer, mesh);
  RaceResult result;
  result.solver.name = solver.info.full_name();
  result.peer.name = peer.info.full_name();
  for (int i = 0; i < preparations; ++i) {
    result.solver.preparation.push_back(first.prepare());
    result.peer.preparation.push_back(second.prepare());
  }
  result.solver.prepared_bytes = first.bytes();
  result.peer.prepared_bytes = second.bytes();
  for (const Index source : sources) result.void_runs += race_from(source, options.runs, first, second, result);
  return result;
}

void print(std::ostream& out, const RaceResult& result) {
  print_lane(out, result.solver);
  print_lane(out, result.peer);
  const std::vector<double> of_solver = medians(result.solver.query), of_peer = medians(result.peer.query);
  std::vector<double> ratio;
  for (std::size_t i = 0; i < of_solver.size(); ++i) ratio.push_back(of_peer[i] / of_solver[i]);
  const auto [least, most] = std::minmax_element(ratio.begin(), ratio.end());
  char text[400];
  std::snprintf(text, sizeof text,
                "peer / solver: query %.3f (median of %zu sources; %.3f to %.3f), preparation %.3f; %zu runs void\n"
                "largest difference of distances: %.3g of the largest distance\n",
                median(ratio), ratio.size(), *least, *most,
                median(result.peer.preparation) / median(result.solver.preparation), result.void_runs,
                result.worst_difference);
  out << text;
}

}  // namespace geodrome::bench
