// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/witness.hpp"

#include <string>
#include <utility>

#include "tools/bench/solvers/runner.hpp"

namespace geodrome::bench {

Witness::Witness(const Plugin<ShortestPathSolver>& plugin, MeshPtr mesh, double seconds)
    : plugin_(plugin), mesh_(std::move(mesh)), common_(*mesh_), context_(seconds) {
  require_needs(plugin_.info, *mesh_);
  plugin_.call([&](const ShortestPathSolver& solver) {
    prepared_ = solver.prepare(mesh_, context_);
    search_ = prepared_->make_search();
  });
}

void Witness::run(std::span<const Source> sources, const Request& request) {
  sources_.assign(sources.begin(), sources.end());
  context_.restart();
  plugin_.call([&](const ShortestPathSolver&) { map_ = &search_->run(sources_, request, context_); });
}

std::vector<double> Witness::at(std::span<const SurfacePoint> points) const {
  std::vector<double> values;
  values.reserve(points.size());
  plugin_.call([&](const ShortestPathSolver&) {
    for (const SurfacePoint& point : points) values.push_back(map_->at(point).value);
  });
  return values;
}

std::vector<double> Witness::lower_bounds(std::span<const SurfacePoint> points) const {
  const LowerBounds& stated = *plugin_.extension<LowerBounds>();
  std::vector<double> values;
  values.reserve(points.size());
  plugin_.call([&](const ShortestPathSolver&) {
    for (const SurfacePoint& point : points) values.push_back(stated.at(*map_, point));
  });
  return values;
}

std::vector<SurfacePoint> Witness::traced(const SurfacePoint& from) const {
  std::vector<SurfacePoint> path;
  plugin_.call([&](const ShortestPathSolver&) { map_->path(from, path); });
  return path;
}

MeasuredPath Witness::path(const SurfacePoint& from) const {
  const std::vector<SurfacePoint> path = traced(from);
  const Index source = plugin_.call([&](const ShortestPathSolver&) { return map_->at(from).source; });
  if (path.empty() || source >= sources_.size()) return {};
  const auto miss_start = common_.straight(path.front(), from);
  const auto miss_end = common_.straight(path.back(), sources_[source].at);
  if (!miss_start || !miss_end) return {};
  MeasuredPath measured{sources_[source].start, *miss_start + *miss_end};
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const auto step = common_.straight(path[i], path[i + 1]);
    if (!step) return {};
    measured.length += *step;
  }
  return measured;
}

AuditResult Witness::audited(double share, std::uint64_t seed) const {
  return plugin_.call([&](const ShortestPathSolver&) {
    return audit(*mesh_, sources_, *map_, plugin_.info.provides,
                 {.factor = plugin_.factor, .share = share, .seed = seed});
  });
}

}  // namespace geodrome::bench
