// SPDX-License-Identifier: MIT
#include "engine/checks/row_audit.hpp"

#include <algorithm>
#include <cmath>

#include "engine/checks/lipschitz.hpp"
#include "engine/checks/rounding_scale.hpp"
#include "engine/host/stage_context.hpp"

namespace geodrome {

namespace {

constexpr std::size_t most_audited = 3;

std::vector<std::size_t> audited(std::span<const NamedPoint> sources, double max_distance) {
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < sources.size(); ++i)
    if (sources[i].place.state == Place::State::on_surface && sources[i].start <= max_distance) usable.push_back(i);
  if (usable.size() <= most_audited) return usable;
  return {usable.front(), usable[usable.size() / 2], usable.back()};
}

}  // namespace

RowAudit::RowAudit(const PreparedSolver& solver, const SourceSurfaces& surfaces, std::span<const NamedPoint> sources,
                   double max_distance, double share)
    : solver_(solver), surfaces_(surfaces), sources_(sources), max_distance_(max_distance), share_(share) {
  if (share_ > 0) chosen_ = audited(sources, max_distance);
}

void RowAudit::hear(std::uint64_t source, const SourceSurface& on, std::span<const double> vertices,
                    std::span<const double> row) {
  if (share_ <= 0) return;
  const double factor = solver_.plugin.factor;
  const bool promised = std::isfinite(factor) && solver_.states_factor_at(on.source.place);
  const Source from{on.source.place.at, 0};
  DistanceAudit found;
  if (promised)
    found = audit_vertices(*on.mesh, vertices, factor, max_distance_ - on.source.start, {&from, 1},
                           "source " + on.source.label);
  const std::lock_guard lock(mutex_);
  if (looks_at(source)) {
    heard_[source].assign(vertices.begin(), vertices.end());
    rows_[source].assign(row.begin(), row.end());
  }
  result_.searches += promised;
  // Of searches that are as bad the first in the list, whichever thread was faster.
  if (found.worst > worst_search_.worst || (found.worst == worst_search_.worst && source < worst_source_))
    worst_search_ = found, worst_source_ = source;
}

std::vector<std::vector<double>> RowAudit::heard_rows() const {
  std::vector<std::vector<double>> rows;
  for (const std::size_t source : chosen_) {
    const auto found = rows_.find(source);
    rows.push_back(found == rows_.end() ? std::vector<double>{} : found->second);
  }
  return rows;
}

void RowAudit::judge_row(std::size_t source, std::span<const double> row, double rounding, std::uint64_t seed,
                         RunContext& context) {
  const SourceSurface on = surfaces_.of(sources_[source]);
  const bool same = on.mesh == surfaces_.reconstruction();
  const PreparedSolver own = same ? solver_ : prepared_on(solver_, on.mesh, context);
  std::vector<Distance> distances;
  for (const double value : row)
    distances.push_back({value, value < infinity ? Reach::reached : Reach::beyond_limit, 0});
  const GivenDistances given{.sources = {&on.source, 1},
                             .targets = *on.targets,
                             .distances = distances,
                             .max_distance = max_distance_,
                             .vertices = heard_[source],
                             .rows = sources_.size(),
                             .rounding = rounding};
  result_.found.add(audit_distances(own, *on.mesh, given, share_, seed, context));
  result_.sources.push_back(sources_[source].label);
}

RowsAudit RowAudit::judge(std::span<const std::vector<double>> rows, double rounding, std::uint64_t seed,
                          RunContext& context) {
  const Stopwatch watch;
  if (chosen_.empty()) result_.found.not_audited = share_ <= 0 ? "switched off" : "no source lies on the surface";
  for (std::size_t k = 0; k < chosen_.size(); ++k) {
    if (!rows[k].empty()) judge_row(chosen_[k], rows[k], rounding, seed + k, context);
    context.throw_if_cancelled();
    context.progress((k + 1.0) / static_cast<double>(chosen_.size()));
  }
  result_.found.add(worst_search_);
  result_.seconds = watch.seconds();
  return std::move(result_);
}

}  // namespace geodrome
