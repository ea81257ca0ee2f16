// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/repeat.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <future>
#include <ostream>
#include <thread>

#include "engine/report/median.hpp"
#include "tools/bench/solvers/runner.hpp"

namespace geodrome::bench {
namespace {

/// A thread's share of the work.
class Worker {
 public:
  explicit Worker(SolverRunner runner) : runner_(std::move(runner)), making_(runner_.make_search()) {}

  void take_sources(const std::vector<Index>& sources, std::atomic<std::size_t>& next) {
    for (std::size_t i = next++; i < sources.size(); i = next++) {
      if (query_.empty()) first_source_ = sources[i];
      query_.push_back(runner_.query(sources[i]));
    }
  }

  /// A worker that came too late for any source has nothing to tell.
  void report(RepeatTimes& times) {
    if (query_.empty()) return;
    times.making.push_back(making_);
    times.query.insert(times.query.end(), query_.begin(), query_.end());
    times.first.push_back(query_.front());
    times.first_again.push_back(runner_.query(first_source_));
  }

 private:
  SolverRunner runner_;
  double making_;
  std::vector<double> query_;
  Index first_source_ = no_index;
};

void run_all(std::vector<Worker>& workers, const std::vector<Index>& sources) {
  std::atomic<std::size_t> next = 0;
  if (workers.size() == 1) return workers.front().take_sources(sources, next);
  std::vector<std::future<void>> running;
  for (Worker& worker : workers)
    running.push_back(std::async(std::launch::async, [&] { worker.take_sources(sources, next); }));
  for (auto& future : running) future.get();
}

}  // namespace

RepeatTimes repeat(const Plugin<ShortestPathSolver>& solver, const MeshPtr& mesh, const RepeatOptions& options) {
  const std::vector<Index> sources = choose_sources(*mesh, options.sources, options.seed);
  const std::size_t wanted = options.threads ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  SolverRunner prepared(solver, mesh);
  RepeatTimes times;
  times.preparation = prepared.prepare();
  std::vector<Worker> workers;
  for (std::size_t i = 0; i < std::min(wanted, sources.size()); ++i) workers.emplace_back(prepared.shared());
  times.all = seconds_of([&] { run_all(workers, sources); });
  for (Worker& worker : workers) worker.report(times);
  return times;
}

RepeatRates rates_of(const RepeatTimes& times) {
  const auto threads = static_cast<double>(times.first.size());
  return {static_cast<double>(times.query.size()) / (times.all * threads), 1 / median(times.query)};
}

void print(std::ostream& out, const std::string& name, const RepeatTimes& times) {
  const RepeatRates rates = rates_of(times);
  const auto [least, most] = std::minmax_element(times.query.begin(), times.query.end());
  const double first = median(times.first), typical = median(times.query);
  char text[600];
  std::snprintf(text, sizeof text,
                "%-24s preparation %10.6f s   making a search %10.6f s   %zu sources, threads: %zu, %10.6f s\n"
                "sources a second a core: %.2f in total, %.2f by the median query (%.6f s; %.6f to %.6f)\n"
                "first query of a search: %.6f s; the median query takes %.3f of it, the same query at the end %.3f\n",
                name.c_str(), times.preparation, median(times.making), times.query.size(), times.first.size(),
                times.all, rates.total, rates.median, typical, *least, *most, first, typical / first,
                median(times.first_again) / first);
  out << text;
}

}  // namespace geodrome::bench
