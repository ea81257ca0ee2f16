// SPDX-License-Identifier: MIT
#include "engine/checks/surface_audit.hpp"

#include <algorithm>

#include "engine/host/stage_context.hpp"

namespace geodrome {

namespace {

constexpr std::size_t audited_sources = 3;

std::vector<const NamedPoint*> choose(std::span<const NamedPoint> sources) {
  std::vector<const NamedPoint*> usable;
  for (const NamedPoint& source : sources)
    if (source.place.state == Place::State::on_surface) usable.push_back(&source);
  if (usable.size() <= audited_sources) return usable;
  return {usable.front(), usable[usable.size() / 2], usable.back()};
}

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

}  // namespace

AuditSummary audit_sources(const PreparedSolver& solver, const SourceSurfaces& surfaces,
                           std::span<const NamedPoint> sources, double share, std::uint64_t seed, RunContext& context) {
  AuditSummary summary;
  const std::vector<const NamedPoint*> chosen = choose(sources);
  summary.not_audited = reason_not_to(solver, share, !chosen.empty());
  if (!summary.not_audited.empty()) return summary;
  const Stopwatch watch;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const SourceSurface on = surfaces.of(*chosen[i]);
    const bool same = on.mesh == surfaces.reconstruction();
    const PreparedSolver own = same ? solver : prepared_on(solver, on.mesh, context);
    const auto search = make_search(own);
    const Source source{on.source.place.at, 0};
    const ShortestPathMap& map = run_search(solver, *search, {&source, 1}, {.keep = Keep::map}, context);
    const AuditOptions options{.factor = solver.plugin.factor, .share = share, .seed = seed + i};
    add(summary.worst, cross_boundary(solver.plugin.info, [&] {
          return audit(*on.mesh, {&source, 1}, map, solver.plugin.info.provides, options);
        }));
    summary.sources.push_back(chosen[i]->label);
    context.throw_if_cancelled();
    context.progress((i + 1.0) / static_cast<double>(chosen.size()));
  }
  summary.seconds = watch.seconds();
  return summary;
}

}  // namespace geodrome
