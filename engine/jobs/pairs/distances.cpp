// SPDX-License-Identifier: MIT
#include "engine/jobs/pairs/distances.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "engine/checks/invariants.hpp"
#include "engine/checks/rounding_scale.hpp"
#include "engine/host/stage_context.hpp"
#include "engine/search/distances.hpp"
#include "engine/search/parallel_rows.hpp"

namespace geodrome {

namespace {

/// Pairs that a thread takes at once: a query may take less time than taking it.
constexpr std::size_t block = 256;

bool on_surface(const NamedPair& pair) {
  return pair.from.place.state == Place::State::on_surface && pair.to.place.state == Place::State::on_surface;
}

void ask(const PreparedSolver& solver, const PairOracle& oracle, std::span<const NamedPair> pairs, unsigned threads,
         RunContext& context, PairDistances& result) {
  const std::uint64_t blocks = (pairs.size() + block - 1) / block;
  result.threads = static_cast<unsigned>(std::clamp<std::uint64_t>(blocks, 1, std::max(threads, 1u)));
  result.values.resize(pairs.size());
  result.asked = static_cast<std::uint64_t>(std::ranges::count_if(pairs, on_surface));
  std::atomic<std::uint64_t> done = 0;
  const auto answer = [&](std::uint64_t number) {
    const std::size_t begin = number * block, end = std::min(begin + block, pairs.size());
    cross_boundary(solver.plugin.info, [&] {
      for (std::size_t i = begin; i < end; ++i) result.values[i] = pair_distance(oracle, pairs[i], i);
    });
    context.progress(static_cast<double>(++done) / static_cast<double>(blocks));
  };
  const Stopwatch watch;
  run_rows(
      blocks, threads, [&] { return RowWorker(answer); }, context);
  result.seconds = watch.seconds();
}

void check(const SurfaceMesh& mesh, bool never_below, std::span<const NamedPair> pairs, PairDistances& result) {
  const std::vector<Index> of_vertex = vertex_components(mesh);
  const double slack = float64_tolerance * RoundingScale().distances(result.values).points(mesh.positions()).value();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Place &from = pairs[i].from.place, &to = pairs[i].to.place;
    const double value = result.values[i];
    const Index target = component_of(mesh, of_vertex, to);
    count_reach({&value, 1}, component_of(mesh, of_vertex, from), {&target, 1}, false, result.reach);
    if (!on_surface(pairs[i]) || !std::isfinite(value)) continue;
    // A weight below 1 may make the way shorter than the straight line.
    const bool bounded = never_below && mesh.face_weights().empty();
    if (bounded && value < distance(mesh.position(from.at), mesh.position(to.at)) - slack) ++result.below_euclid;
    if (from.at == to.at && value > slack) ++result.not_zero;
  }
}

/// Turns distances along the surface into those of the rule.
void apply_rule(const PlacedSurface& surface, std::span<const NamedPair> pairs, std::span<double> values) {
  const DistanceRule rule{surface.made_from == InputKind::points};
  for (std::size_t i = 0; i < pairs.size(); ++i) values[i] = rule(values[i], pairs[i].from, pairs[i].to);
}

}  // namespace

std::vector<double> ask_pairs(const PlacedSurface& surface, const PreparedSolver& solver, const PairOracle& oracle,
                              std::span<const NamedPair> pairs, unsigned threads, RunContext& context) {
  PairDistances result;
  ask(solver, oracle, pairs, threads, context, result);
  apply_rule(surface, pairs, result.values);
  return std::move(result.values);
}

PairDistances pair_distances(const PlacedSurface& surface, const PreparedSolver& solver, const PairOracle& oracle,
                             std::span<const NamedPair> pairs, unsigned threads, RunContext& context) {
  PairDistances result;
  ask(solver, oracle, pairs, threads, context, result);
  check(*surface.mesh, solver.provides(Provides::never_shorter), pairs, result);
  result.audit = audit_pairs(*surface.mesh, solver, pairs, result.values, context);
  apply_rule(surface, pairs, result.values);
  return result;
}

PairDistances pair_distances(const PlacedSurface& surface, const PreparedSolver& solver,
                             std::span<const NamedPair> pairs, const RunSettings& settings, Observer& observer) {
  PairDistances result{.threads = thread_count(settings)};
  const Stopwatch watch;
  SearchedPairs found = search_pairs(surface, solver, pairs, settings, observer);
  result.seconds = watch.seconds();
  result.searches = found.searches, result.smooth = found.paths;
  result.values = std::move(found.flat);
  check(*surface.mesh, solver.provides(Provides::never_shorter), pairs, result);
  StageContext context("audit", observer, 1, settings.seed);
  result.audit = audit_pairs(*surface.mesh, solver, pairs, result.values, context, true);
  result.values = std::move(found.smooth);
  return result;
}

}  // namespace geodrome
