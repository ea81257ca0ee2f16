// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/measure.hpp"

#include <malloc.h>

#include "engine/host/stage_context.hpp"
#include "engine/report/memory.hpp"
#include "engine/search/counter_sum.hpp"
#include "engine/search/distances.hpp"

namespace geodrome {

namespace {

/// How far resident memory rises above what it is when this is made.
class MemoryRise {
 public:
  MemoryRise() {
    // What was freed but not returned would be used again without being seen; code that a process runs for the first
    // time would count as memory of whoever runs it first.
    malloc_trim(0);
    make_code_resident();
    counts_ = reset_memory_peak();
    before_ = memory_now();
  }

  std::optional<std::uint64_t> bytes() const {
    if (!counts_ || before_ == 0) return std::nullopt;
    const std::size_t peak = memory_peak();
    return peak > before_ ? peak - before_ : 0;
  }

 private:
  bool counts_ = false;
  std::size_t before_ = 0;
};

/// Progress within the searches as progress of all.
class ProgressOfAll final : public Observer {
 public:
  ProgressOfAll(Observer& observer, std::size_t searches) : observer_(observer), searches_(searches) {}

  void next() { ++done_; }
  void progress(std::string_view stage, double fraction) override {
    observer_.progress(stage, (static_cast<double>(done_) + fraction) / static_cast<double>(searches_));
  }
  void log(LogLevel level, std::string_view message) override { observer_.log(level, message); }
  std::string words(const Remedy& remedy) const override { return observer_.words(remedy); }
  bool cancelled() const noexcept override { return observer_.cancelled(); }

 private:
  Observer& observer_;
  std::size_t searches_, done_ = 0;
};

std::map<std::string, double> means(const std::map<std::string, std::uint64_t>& sums, std::size_t searches) {
  std::map<std::string, double> result;
  for (const auto& [name, sum] : sums)
    result[name] = static_cast<double>(sum) / static_cast<double>(is_largest(name) ? 1 : searches);
  return result;
}

/// Adds the intervals that the search of a source certifies.
void certify(Measurement& measured, const SurfaceMesh& mesh, const ShortestPathMap& map, std::size_t source) {
  const std::optional<IntervalFigures> figures = audit_intervals(measured.solver, mesh, map);
  if (!figures) return;
  if (!measured.certified) measured.certified.emplace();
  measured.certified->add(*figures, source);
}

}  // namespace

Measurement measure(const ComparedSurface& on, const Plugin<ShortestPathSolver>& solver, const PluginHost& host,
                    const RunSettings& settings, const std::string& name, Observer& observer) {
  const std::span<const NamedPoint> targets = on.targets.named();
  Measurement measured;
  measured.rows.assign(on.sources.size(), std::vector<double>(targets.size()));
  const MemoryRise rise;

  const Stopwatch preparing;
  measured.solver = prepare_solver(solver, on.surface->mesh, host, settings, observer);
  check_provides(measured.solver.plugin.info, ProjectionRule::project, on.sources, targets, infinity);
  const auto search = make_search(measured.solver);
  SearchCost& cost = measured.cost;
  cost.prepare_seconds = preparing.seconds();

  ProgressOfAll all(observer, on.sources.size());
  StageContext context(name, all, 1, settings.seed);
  CounterSum counters;
  std::size_t searches = 0;
  for (std::size_t i = 0; i < on.sources.size(); ++i) {
    const Stopwatch searching;
    const ShortestPathMap* map =
        distance_row(measured.solver, *search, on.sources[i], on.targets, infinity, context, measured.rows[i]);
    cost.source_seconds.push_back(searching.seconds());
    if (map) {
      ++searches;
      counters.add(measured.solver, *map);
      certify(measured, *on.surface->mesh, *map, i);
    }
    context.throw_if_cancelled();
    all.next();
  }
  cost.peak_bytes = rise.bytes();
  cost.vertices = on.surface->mesh->vertex_count(), cost.faces = on.surface->mesh->face_count();
  cost.counters = means(counters.sums(), searches);
  cost.prepared_bytes = cross_boundary(measured.solver.plugin.info, [&] { return measured.solver.prepared->bytes(); });
  return measured;
}

}  // namespace geodrome
