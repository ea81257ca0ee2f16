// SPDX-License-Identifier: MIT
#include "engine/checks/surface_audit.hpp"

#include <algorithm>
#include <cmath>

#include "engine/formats/number_text.hpp"
#include "engine/host/stage_context.hpp"
#include "engine/search/distances.hpp"

namespace geodrome {

namespace {

constexpr std::size_t most_audited = 3;

void add(AuditResult& sum, const AuditResult& one) {
  sum.faces += one.faces, sum.pairs += one.pairs, sum.paths += one.paths;
  sum.scale = std::max(sum.scale, one.scale);
  const bool worse = std::max(one.worst_lipschitz, one.worst_path) > std::max(sum.worst_lipschitz, sum.worst_path);
  if (worse || sum.where.empty()) sum.where = one.where;
  if (one.worst_lipschitz > sum.worst_lipschitz) {
    sum.worst_lipschitz = one.worst_lipschitz;
    sum.worst_lipschitz_face = one.worst_lipschitz_face;
  }
  if (one.worst_path > sum.worst_path) {
    sum.worst_path = one.worst_path;
    sum.worst_path_face = one.worst_path_face;
  }
}

std::string reason_not_to(const PreparedSolver& solver, double share, bool any_source) {
  if (share <= 0) return "switched off";
  if (!any_source) return "no source lies on the surface";
  if (!solver.provides(Provides::any_point) || !solver.provides(Provides::paths))
    return solver.plugin.info.full_name() + " does not provide any_point and paths";
  return {};
}

/// How far two answers of a solver for one distance are apart beyond what its factor and storing allow.
double violation(double given, double found, double factor, const GivenRows& terms) {
  if (std::isnan(given) || std::isnan(found)) return std::isnan(given) == std::isnan(found) ? 0 : infinity;
  if (given == found) return 0;
  const auto at_least = [&](double value) { return value == infinity ? terms.max_distance : value; };
  const auto excess = [&](double a, double b) { return b == infinity ? 0 : at_least(a) - factor * b; };
  return std::max(excess(given, found), excess(found, given)) - terms.rounding * std::max(found, 0.0);
}

void compare_row(const GivenRows& given, std::size_t number, const SourceSurface& on, const ShortestPathMap& map,
                 const PreparedSolver& solver, AuditSummary& summary) {
  const double factor = solver.plugin.factor;
  if (given.rows.empty() || !std::isfinite(factor) || !solver.states_factor_at(on.source.place)) return;
  const std::vector<double>& row = given.rows[number];
  std::vector<double> found(row.size());
  read_row(&map, on.source, *on.targets, given.max_distance, found);
  for (std::size_t j = 0; j < row.size(); ++j) {
    const double missed = violation(row[j], found[j], factor, given);
    if (!solver.states_factor_at(on.targets->named()[j].place) || !(missed > summary.worst_given)) continue;
    summary.worst_given = missed;
    summary.where_given = "the distance of target " + on.targets->named()[j].label + " from source " + on.source.label +
                          " is " + number_text(row[j]) + ", searched for anew " + number_text(found[j]);
  }
}

}  // namespace

std::vector<std::size_t> audited_sources(std::span<const NamedPoint> sources) {
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < sources.size(); ++i)
    if (sources[i].place.state == Place::State::on_surface) usable.push_back(i);
  if (usable.size() <= most_audited) return usable;
  return {usable.front(), usable[usable.size() / 2], usable.back()};
}

AuditSummary audit_sources(const PreparedSolver& solver, const SourceSurfaces& surfaces,
                           std::span<const NamedPoint> sources, const GivenRows& given, double share,
                           std::uint64_t seed, RunContext& context) {
  AuditSummary summary;
  const std::vector<std::size_t> chosen = audited_sources(sources);
  summary.not_audited = reason_not_to(solver, share, !chosen.empty());
  if (!summary.not_audited.empty()) return summary;
  const Stopwatch watch;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const SourceSurface on = surfaces.of(sources[chosen[i]]);
    const bool same = on.mesh == surfaces.reconstruction();
    const PreparedSolver own = same ? solver : prepared_on(solver, on.mesh, context);
    const auto search = make_search(own);
    const Source source{on.source.place.at, 0};
    const ShortestPathMap& map =
        run_search(own, *search, {&source, 1}, {.targets = on.targets->points(), .keep = Keep::map}, context);
    const AuditOptions options{.factor = solver.plugin.factor, .share = share, .seed = seed + i};
    add(summary.worst, cross_boundary(solver.plugin.info, [&] {
          compare_row(given, i, on, map, solver, summary);
          return audit(*on.mesh, {&source, 1}, map, solver.plugin.info.provides, options);
        }));
    summary.sources.push_back(sources[chosen[i]].label);
    context.throw_if_cancelled();
    context.progress((i + 1.0) / static_cast<double>(chosen.size()));
  }
  if (summary.worst.scale > 0) summary.worst_given /= summary.worst.scale;
  summary.seconds = watch.seconds();
  return summary;
}

}  // namespace geodrome
