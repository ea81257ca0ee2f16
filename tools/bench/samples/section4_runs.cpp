// SPDX-License-Identifier: MIT
#include "tools/bench/samples/section4_runs.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "engine/report/median.hpp"
#include "tools/bench/samples/sample_case.hpp"
#include "tools/bench/solvers/runner.hpp"
#include "tools/bench/solvers/witness.hpp"

namespace geodrome::bench {
namespace {

constexpr double patience = 3600;  // seconds for one search; none is expected to hang

/// The samples are clean, so that every point has a place.
std::vector<SurfacePoint> places_of(const PlacedSurface& surface) {
  std::vector<SurfacePoint> places;
  for (const Place& place : surface.places) {
    if (place.state != Place::State::on_surface) throw SampleError("a point of a clean sample was dropped");
    places.push_back(place.at);
  }
  return places;
}

}  // namespace

SampledSurface sampled_surface(const ManifoldTask& task, const std::string& shape, const PluginHost& host,
                               const RunSettings& settings) {
  SampleResult result = run_sample(input_of(task.sample), host, settings, expected_topology(shape));
  if (result.outcome != Outcome::right) throw SampleError(result.reason);
  return {std::move(*result.surface), result.seconds};
}

ManifoldRun run_on_manifold(const Plugin<ShortestPathSolver>& solver, const SampledSurface& surface,
                            const ManifoldTask& task) {
  const std::vector<SurfacePoint> places = places_of(surface.surface);
  const std::vector<Vec3>& points = task.sample.points;
  ManifoldRun run;
  std::unique_ptr<Witness> witness;
  run.prepare_seconds =
      seconds_of([&] { witness = std::make_unique<Witness>(solver, surface.surface.mesh, patience); });
  std::vector<double> seconds;
  std::vector<std::vector<double>> computed;  // to all points, for that is what is timed
  for (const Index source : task.sources) {
    std::vector<double>& row = computed.emplace_back();
    const Source start{places[source]};
    seconds.push_back(seconds_of([&] {
      witness->run({&start, 1}, {.targets = places, .keep = Keep::targets});
      row = witness->at(places);
    }));
    for (std::size_t t = 0; t < row.size(); ++t) row[t] = std::max(row[t], distance(points[source], points[t]));
  }
  run.errors = distance_errors(task.truth, at_targets(task, computed));
  run.seconds = median(seconds);
  run.total_seconds = surface.seconds + run.prepare_seconds + std::accumulate(seconds.begin(), seconds.end(), 0.0);
  return run;
}

}  // namespace geodrome::bench
