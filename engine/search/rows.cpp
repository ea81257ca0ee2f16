// SPDX-License-Identifier: MIT
#include "engine/search/rows.hpp"

#include <utility>

#include "engine/search/distances.hpp"
#include "engine/search/lower_bounds.hpp"
#include "engine/search/parallel_rows.hpp"

namespace geodrome {

RowMaker::RowMaker(const PreparedSolver& solver, const SourceSurfaces& surfaces, std::span<const NamedPoint> sources,
                   double max_distance, std::uint64_t seed, Observer& observer, RowExtras extras)
    : solver_(solver),
      surfaces_(surfaces),
      sources_(sources),
      max_distance_(max_distance),
      quiet_(observer),
      context_(ShortestPathSolver::stage, quiet_, 1, seed),
      extras_(std::move(extras)),
      smooth_(solver.smooth ? sources.size() : 0) {}

void RowMaker::make(Search& search, std::uint64_t i, std::span<double> row) {
  const SourceSurface on = surfaces_.of(sources_[i]);
  if (sources_[i].place.state == Place::State::on_surface) ++insertions_[static_cast<std::size_t>(on.how)];
  if (on.mesh == surfaces_.reconstruction()) return measure(solver_, search, i, on, row);
  const PreparedSolver own = prepared_on(solver_, on.mesh, context_);
  measure(own, *make_search(own), i, on, row);
}

void RowMaker::measure(const PreparedSolver& solver, Search& search, std::uint64_t i, const SourceSurface& on,
                       std::span<double> row) {
  const std::size_t targets = on.targets->size();
  const std::span<double> distances = row.first(targets);
  const bool smooth = solver.smooth != nullptr;
  const double radius = searched_radius(solver, max_distance_);
  const bool marches = smooth && solver.smooth->curves && extras_.looks_at_row && !extras_.looks_at_row(i);
  const Reading reading = marches ? Reading::vertices : Reading::all;
  const ShortestPathMap* map = distance_row(solver, search, on.source, *on.targets, radius, context_, distances,
                                            smooth ? Keep::map : Keep::targets, reading);
  if (extras_.bounds)
    cross_boundary(solver.plugin.info, [&] {
      read_lower_bounds(solver, map, on.source, *on.targets, max_distance_, distances, row.subspan(targets));
    });
  if (!map) return;
  counters_.add(solver_, *map);
  if (extras_.watch) extras_.watch(i, on, *map, distances);
  if (smooth) smooth_[i] = smooth_row(solver, *map, on.source, *on.targets, max_distance_, distances, reading);
}

std::optional<SmoothFigures> RowMaker::smooth() const {
  if (!solver_.smooth) return std::nullopt;
  SmoothFigures sum;
  for (const SmoothFigures& row : smooth_) sum.add(row);
  return sum;
}

std::map<std::string, std::uint64_t> RowMaker::insertions() const {
  if (surfaces_.rule() == ProjectionRule::project) return {};
  constexpr const char* names[] = {"existing", "cavity", "partial", "extended"};  // as Insertion
  std::map<std::string, std::uint64_t> counts;
  for (std::size_t how = 0; how < insertions_.size(); ++how) counts[names[how]] = insertions_[how];
  return counts;
}

void compute_rows(const RowSet& rows, const PreparedSolver& solver, RowMaker& maker, RowSink& sink, unsigned threads,
                  RunContext& context) {
  const auto make_filler = [&]() -> RowFiller {
    return [&maker, search = std::shared_ptr(make_search(solver))](std::uint64_t i, std::span<double> row) {
      if (i > 0) return maker.make(*search, i, row);
      maker.make(*make_search(maker.solver()), i, row);
    };
  };
  fill_rows(rows, sink, maker.columns(), threads, make_filler, context);
}

}  // namespace geodrome
