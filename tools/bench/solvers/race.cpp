// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/race.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

#include "engine/report/median.hpp"
#include "tools/bench/solvers/runner.hpp"

namespace geodrome::bench {
namespace {

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

/// All runs from one source; returns how many were void.
std::size_t race_from(Index source, std::size_t runs, SolverRunner& solver, SolverRunner& peer, RaceResult& result) {
  solver.query(source);
  peer.query(source);
  result.worst_difference = std::max(result.worst_difference, worst_difference(solver.distances(), peer.distances()));
  result.solver.windows.push_back(solver.figures().windows);
  result.peer.windows.push_back(peer.figures().windows);
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

/// Over the sources: nanoseconds of a query a window, and windows an edge of the mesh.
std::string window_text(const Lane& lane, std::size_t edges) {
  const std::vector<double> query = medians(lane.query);
  std::vector<Figure> time, number;
  for (std::size_t i = 0; i < query.size(); ++i) {
    time.push_back(quotient(1e9 * query[i], lane.windows[i]));
    number.push_back(quotient(lane.windows[i], static_cast<double>(edges)));
  }
  return figure_text(median_figure(time), 1) + " ns a window   " + figure_text(median_figure(number), 2) +
         " windows an edge";
}

void print_lane(std::ostream& out, const Lane& lane, std::size_t edges) {
  char line[200];
  std::snprintf(line, sizeof line, "%-24s preparation %10.6f s   query %10.6f s   prepared surface %8.2f MB   ",
                lane.name.c_str(), median(lane.preparation), median(medians(lane.query)),
                static_cast<double>(lane.prepared_bytes) * 1e-6);
  out << line << window_text(lane, edges) << '\n';
}

}  // namespace

RaceResult race(const Plugin<ShortestPathSolver>& solver, const Plugin<ShortestPathSolver>& peer, const MeshPtr& mesh,
                const RaceOptions& options) {
  constexpr int preparations = 3;
  const std::vector<Index> sources = choose_sources(*mesh, options.sources, options.seed);
  SolverRunner first(solver, mesh), second(peer, mesh);
  RaceResult result;
  result.solver.name = solver.info.full_name();
  result.peer.name = peer.info.full_name();
  for (int i = 0; i < preparations; ++i) {
    result.solver.preparation.push_back(first.prepare());
    result.peer.preparation.push_back(second.prepare());
  }
  first.make_search();
  second.make_search();
  result.edges = edge_count(*mesh);
  result.solver.prepared_bytes = first.prepared_bytes();
  result.peer.prepared_bytes = second.prepared_bytes();
  for (const Index source : sources) result.void_runs += race_from(source, options.runs, first, second, result);
  return result;
}

void print(std::ostream& out, const RaceResult& result) {
  print_lane(out, result.solver, result.edges);
  print_lane(out, result.peer, result.edges);
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
