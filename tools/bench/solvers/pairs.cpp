// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/pairs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <streambuf>

#include "engine/report/median.hpp"
#include "tools/bench/solvers/runner.hpp"
#include "tools/bench/solvers/search_figures.hpp"
#include "tools/bench/solvers/surface_points.hpp"
#include "tools/shapes/random.hpp"

namespace geodrome::bench {
namespace {

constexpr double tolerance = 1e-12;  ///< relative to the largest distance: what "exact" means in this project

class ThreadedContext final : public QuietContext {
 public:
  explicit ThreadedContext(unsigned threads) : threads_(std::max(threads, 1u)) {}
  unsigned threads() const noexcept override { return threads_; }

 private:
  unsigned threads_;
};

/// Counts what is written and keeps nothing.
class CountingBuffer final : public std::streambuf {
 public:
  std::uint64_t bytes() const { return bytes_; }

 protected:
  std::streamsize xsputn(const char*, std::streamsize count) override {
    bytes_ += static_cast<std::uint64_t>(count);
    return count;
  }
  int_type overflow(int_type c) override {
    ++bytes_;
    return traits_type::not_eof(c);
  }

 private:
  std::uint64_t bytes_ = 0;
};

void demand(const PluginInfo& solver, Provides bits, const char* what) {
  if (!has(solver.provides, bits)) throw CapabilityError(solver.full_name() + " does not provide " + what);
}

SurfacePoint point_in_face(const SurfaceMesh& mesh, shapes::Random& random) {
  const double a = std::sqrt(random.uniform()), b = random.uniform();
  return {static_cast<Index>(random.index(mesh.face_count())), {1 - a, a * (1 - b), a * b}};
}

/// A solver prepared on a mesh.
struct Prepared {
  const Plugin<ShortestPathSolver>& plugin;
  std::unique_ptr<PreparedSurface> surface;
  double seconds = 0;

  Prepared(const Plugin<ShortestPathSolver>& solver, const MeshPtr& mesh, RunContext& context) : plugin(solver) {
    require_needs(plugin.info, *mesh);
    seconds = seconds_of(
        [&] { surface = plugin.call([&](const ShortestPathSolver& stage) { return stage.prepare(mesh, context); }); });
  }

  std::unique_ptr<Search> make_search() const {
    return plugin.call([&](const ShortestPathSolver&) { return surface->make_search(); });
  }
};

/// Distances of some targets from one source.
std::vector<double> search(const Prepared& prepared, Search& search, const SurfacePoint& from,
                           std::span<const SurfacePoint> targets, bool stop) {
  return prepared.plugin.call([&](const ShortestPathSolver&) {
    QuietContext context;
    const Source source{from, 0};
    const ShortestPathMap& map = search.run({&source, 1}, {.targets = targets, .stop_at_targets = stop}, context);
    std::vector<double> distances;
    for (const SurfacePoint& target : targets) distances.push_back(map.at(target).value);
    return distances;
  });
}

/// One pair a search; the first one is not timed.
SearchSeconds time_searches(const Prepared& prepared, const PairSet& pairs, std::size_t count) {
  const auto own = prepared.make_search();
  const bool stop = has(prepared.plugin.info.provides, Provides::target_limit);
  const auto one = [&](std::size_t i) { search(prepared, *own, pairs.sources[i], {pairs.targets[i].data(), 1}, stop); };
  one(0);
  std::vector<double> times;
  for (std::size_t i = 0; i < std::min(std::max<std::size_t>(count, 1), pairs.sources.size()); ++i)
    times.push_back(seconds_of([&] { one(i); }));
  return {prepared.seconds, median(times)};
}

double largest_finite(const std::vector<std::vector<double>>& rows) {
  double largest = 0;
  for (const auto& row : rows)
    for (const double value : row)
      if (std::isfinite(value)) largest = std::max(largest, value);
  return largest;
}

/// Compares distances with the truth, pair by pair.
class Comparison {
 public:
  Comparison(double factor, bool anywhere, double scale, PairFigures& figures)
      : factor_(factor), anywhere_(anywhere), slack_(tolerance * scale), figures_(figures) {}

  void add(double value, double truth, bool between_vertices) {
    if (std::isfinite(value) != std::isfinite(truth)) ++figures_.reach_differs;
    if (!std::isfinite(value) || !std::isfinite(truth)) return;
    figures_.below += value < truth - slack_;
    figures_.above += (anywhere_ || between_vertices) && value > factor_ * truth + slack_;
    if (!(truth > slack_)) return;
    ++figures_.compared;
    figures_.largest = std::max(figures_.largest, value / truth - 1);
    sum_ += value / truth - 1;
    figures_.mean = sum_ / static_cast<double>(figures_.compared);
  }

 private:
  double factor_;
  bool anywhere_;
  double slack_, sum_ = 0;
  PairFigures& figures_;
};

/// Answers of all pairs, timed source by source: a single query may take less than reading the clock.
std::vector<std::vector<double>> ask(const Plugin<ShortestPathSolver>& solver, const PairOracle& oracle,
                                     const PairSet& pairs, PairFigures& figures) {
  std::vector<std::vector<double>> answers(pairs.sources.size());
  std::vector<double> times;
  for (std::size_t i = 0; i < pairs.sources.size(); ++i) {
    answers[i].resize(pairs.targets[i].size());
    const auto all_targets = [&] {
      solver.call([&](const ShortestPathSolver&) {
        for (std::size_t j = 0; j < answers[i].size(); ++j)
          answers[i][j] = oracle.distance(pairs.sources[i], pairs.targets[i][j]);
      });
    };
    times.push_back(seconds_of(all_targets) / static_cast<double>(answers[i].size()));
  }
  figures.query = median(times);
  return answers;
}

std::uint64_t saved_bytes(const Plugin<ShortestPathSolver>& solver, const PairOracle& oracle) {
  CountingBuffer buffer;
  std::ostream out(&buffer);
  solver.call([&](const ShortestPathSolver&) { oracle.save(out); });
  return buffer.bytes();
}

std::optional<double> break_even(double once, double saved_a_pair) {
  if (saved_a_pair <= 0) return std::nullopt;
  return std::max(once, 0.0) / saved_a_pair;
}

}  // namespace

PairSet choose_pairs(const SurfaceMesh& mesh, const PairOptions& options) {
  if (mesh.face_count() == 0) throw InputError(InputFault::empty, "the mesh has no face");
  shapes::Random random(options.seed);
  const auto draw = [&](std::size_t i) {
    return i % 2 == 0 ? random_vertex(mesh, random) : point_in_face(mesh, random);
  };
  PairSet pairs;
  const std::size_t sources = std::clamp<std::size_t>(options.sources, 1, std::max<std::size_t>(options.pairs, 1));
  const std::size_t each = std::max<std::size_t>(options.pairs / sources, 1);
  for (std::size_t i = 0; i < sources; ++i) {
    pairs.sources.push_back(draw(i));
    std::vector<SurfacePoint>& targets = pairs.targets.emplace_back();
    // Starting elsewhere for every two sources, so that a single target too is of every kind.
    for (std::size_t j = 0; j < each; ++j) targets.push_back(draw(j + i / 2));
  }
  return pairs;
}

PairTruth truth_of(const Plugin<ShortestPathSolver>& peer, const MeshPtr& mesh, const PairSet& pairs,
                   const PairOptions& options) {
  demand(peer.info, Provides::face_sources | Provides::any_point | Provides::factor_any_point,
         "distances between any points");
  if (peer.factor != 1) throw CapabilityError(peer.info.full_name() + " is not exact");
  QuietContext context;
  const Prepared prepared(peer, mesh, context);
  PairTruth truth{peer.info.full_name(), {}, time_searches(prepared, pairs, options.searches)};
  const auto own = prepared.make_search();
  for (std::size_t i = 0; i < pairs.sources.size(); ++i)
    truth.distances.push_back(search(prepared, *own, pairs.sources[i], pairs.targets[i], false));
  return truth;
}

PairFigures pair_figures(const Plugin<ShortestPathSolver>& solver, const MeshPtr& mesh, const PairSet& pairs,
                         const PairTruth& truth, const PairOptions& options) {
  demand(solver.info, Provides::pair_queries, "distances of arbitrary pairs (pair_queries)");
  ThreadedContext context(options.threads);
  const Prepared prepared(solver, mesh, context);
  PairFigures figures;
  std::unique_ptr<PairOracle> oracle;
  const auto build = [&] { oracle = prepared.surface->pair_oracle(nullptr, context); };
  figures.build = seconds_of([&] { solver.call([&](const ShortestPathSolver&) { build(); }); });
  if (!oracle) throw PluginError(solver.info.full_name() + " made no oracle");
  figures.bytes = saved_bytes(solver, *oracle);
  const auto answers = ask(solver, *oracle, pairs, figures);
  figures.searching = time_searches(prepared, pairs, options.searches);
  Comparison comparison(solver.factor, has(solver.info.provides, Provides::factor_any_point),
                        largest_finite(truth.distances), figures);
  const auto is_vertex = [&](const SurfacePoint& point) { return mesh->vertex_at(point) != no_index; };
  for (std::size_t i = 0; i < answers.size(); ++i)
    for (std::size_t j = 0; j < answers[i].size(); ++j)
      comparison.add(answers[i][j], truth.distances[i][j],
                     is_vertex(pairs.sources[i]) && is_vertex(pairs.targets[i][j]));
  return figures;
}

std::optional<double> pays_above(const PairFigures& oracle) {
  return break_even(oracle.build, oracle.searching.search - oracle.query);
}

std::optional<double> pays_above(const PairFigures& oracle, const SearchSeconds& peer) {
  return break_even(oracle.searching.preparation + oracle.build - peer.preparation, peer.search - oracle.query);
}

std::string pair_names() {
  return " prepare s    build s   index MB   us/query   max error  mean error  above  below  reach   search s  pays "
         "above     peer s  pays above";
}

std::string pair_row(const PairFigures& f, const PairTruth& truth) {
  char line[300];
  std::snprintf(line, sizeof line, "%10.4f %10.4f %10.3f %10.3f %11.3e %11.3e %6zu %6zu %6zu %10.3e %11s %10.3e %11s",
                f.searching.preparation, f.build, static_cast<double>(f.bytes) * 1e-6, f.query * 1e6, f.largest, f.mean,
                f.above, f.below, f.reach_differs, f.searching.search, figure_text(pays_above(f), 0).c_str(),
                truth.seconds.search, figure_text(pays_above(f, truth.seconds), 0).c_str());
  return line;
}

}  // namespace geodrome::bench
