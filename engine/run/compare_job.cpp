// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "engine/run/distance_row.hpp"
#include "engine/run/open_input.hpp"
#include "engine/run/stage_context.hpp"
#include "geodrome/engine/jobs.hpp"

namespace geodrome {

namespace {

/// Rows of distances, one per source.
using Rows = std::vector<std::vector<double>>;

/// Runs one solver on one thread, so that times can be compared.
Rows measure(CompareRow& figures, const Opened& opened, const PluginHost& host, const CompareJob& job,
             std::span<const Query> sources, const TargetList& targets, Observer& observer) {
  const PreparedSolver solver = prepare_solver(opened.surface.mesh, host, figures.solver, job.settings, observer);
  constexpr double no_limit = std::numeric_limits<double>::infinity();
  check_provides(solver, sources, targets.queries(), no_limit);
  figures.factor = solver.plugin.factor;
  figures.prepare_seconds = solver.record.seconds;
  StageContext context(ShortestPathSolver::stage, observer, 1, job.settings.seed);
  const auto search = make_search(solver);
  Rows rows(sources.size(), std::vector<double>(targets.queries().size()));
  const Stopwatch watch;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    distance_row(solver, *search, sources[i], targets, no_limit, context, rows[i]);
    context.throw_if_cancelled();
    observer.progress(figures.solver, (i + 1.0) / static_cast<double>(sources.size()));
  }
  figures.seconds_per_source = watch.seconds() / static_cast<double>(sources.size());
  return rows;
}

void count_unreachable(CompareRow& figures, const Rows& rows) {
  for (const auto& row : rows)
    figures.unreachable +=
        static_cast<std::uint64_t>(std::count_if(row.begin(), row.end(), [](double d) { return std::isinf(d); }));
}

void compare(CompareRow& figures, const Rows& rows, const Rows& first) {
  double sum = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      const double mine = rows[i][j], reference = first[i][j];
      if (std::isfinite(mine) != std::isfinite(reference)) ++figures.reach_differs;
      if (!std::isfinite(mine) || !std::isfinite(reference) || reference == 0) continue;
      const double difference = std::abs(mine - reference) / reference;
      figures.max_difference = std::max(figures.max_difference, difference);
      sum += difference;
      ++figures.compared;
    }
  if (figures.compared > 0) figures.mean_difference = sum / static_cast<double>(figures.compared);
}

}  // namespace

std::vector<CompareRow> run_compare(const CompareJob& job, Observer& observer) {
  if (job.solvers.empty()) throw OptionError("no solver to compare", "name at least one");
  const PluginHost host(job.settings.plugin_path);
  const Opened opened = open_input(job.input, host, job.settings, observer);
  const std::vector<Query> sources = select(job.sources, opened.input, opened.surface);
  const TargetList targets(select("all", opened.input, opened.surface), opened.surface);

  std::vector<CompareRow> table;
  Rows first;  // of the first solver that ran
  for (const std::string& solver : job.solvers) {
    CompareRow figures;
    figures.solver = solver;
    try {
      Rows rows = measure(figures, opened, host, job, sources, targets, observer);
      count_unreachable(figures, rows);
      if (first.empty()) first = rows;
      compare(figures, rows, first);
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      figures.error = error.what();
      figures.error_status = exit_status(error);
    }
    table.push_back(std::move(figures));
  }
  return table;
}

}  // namespace geodrome
