// SPDX-License-Identifier: MIT
#include "engine/search/many_searches.hpp"

#include <algorithm>
#include <tuple>

namespace geodrome {

namespace {

/// The surface made for a plan goes before the one that it may refer to.
struct PlannedSurface {
  std::shared_ptr<const PreparedSurface> original;
  std::unique_ptr<PreparedSurface> planned;
};

auto key(const SurfacePoint& point) { return std::tie(point.face, point.b[0], point.b[1], point.b[2]); }

/// Surface points that are the same number by number are left once.
void keep_each_once(std::vector<SurfacePoint>& points) {
  std::ranges::sort(points, [](const SurfacePoint& a, const SurfacePoint& b) { return key(a) < key(b); });
  const auto repeated =
      std::ranges::unique(points, [](const SurfacePoint& a, const SurfacePoint& b) { return key(a) == key(b); });
  points.erase(repeated.begin(), repeated.end());
}

}  // namespace

std::optional<RowPlan> plan_rows(const PreparedSolver& solver, ProjectionRule rule, std::span<const NamedPoint> sources,
                                 double max_distance) {
  if (rule != ProjectionRule::project || solver.smooth || !solver.plugin.extension<ManySearches>()) return std::nullopt;
  RowPlan plan;
  for (const NamedPoint& source : sources) {
    const double radius = max_distance - source.start;
    if (source.place.state != Place::State::on_surface || !(radius >= 0)) continue;  // as `distance_row`
    plan.sources.push_back(source.place.at);
    plan.radius = std::max(plan.radius, radius);
  }
  keep_each_once(plan.sources);
  if (plan.sources.size() < 2) return std::nullopt;
  return plan;
}

PlannedSolver prepare_plan(const PreparedSolver& solver, const RowPlan& plan, StageContext& context) {
  const ManySearches& table = *solver.plugin.extension<ManySearches>();
  PlannedSolver result{solver, {.sources = plan.sources.size()}};
  const Stopwatch watch;
  auto surface = std::make_shared<PlannedSurface>(solver.prepared);
  surface->planned = cross_boundary(solver.plugin.info, [&] {
    auto planned = table.prepare(*solver.prepared, {plan.sources, plan.radius}, context);
    if (planned) result.record.bytes = planned->bytes();
    return planned;
  });
  result.record.seconds = watch.seconds();
  result.record.measures = context.measures();
  result.record.used = surface->planned != nullptr;
  if (result.record.used) result.solver.prepared = {surface, surface->planned.get()};
  return result;
}

}  // namespace geodrome
