// SPDX-License-Identifier: MIT
#include "plugins/solver_merged_windows/fallback.hpp"

#include <string_view>

namespace geodrome::merged_windows {

void Fallback::begin(bool keep, double limit) {
  is_exact_ = false;
  keep_ = keep, limit_ = limit;
  seeds_.clear();
  merged_.begin(keep, limit);
}

void Fallback::seed(const Source& source, Index number) {
  seeds_.emplace_back(source, number);
  merged_.seed(source, number);
}

/// Begins the run again. Points that were watched keep their order; what was found to them is forgotten.
void Fallback::begin_exact() {
  std::vector<Watched> watched = merged_.watched();
  for (Watched& point : watched) point = {point.at};
  merged_.begin(false, 0);
  if (!exact_) exact_.emplace(surface_, Exact::Settings{});
  is_exact_ = true;
  exact_->begin(keep_, limit_);
  exact_->watched() = std::move(watched);
  for (const auto& [source, number] : seeds_) exact_->seed(source, number);
}

Fallback::Way Fallback::way_to(const SurfacePoint& inner, double best) const {
  if (is_exact_) {
    const Exact::Way way = exact_->way_to(inner, best);
    return {way.distance, way.source, {}, way};
  }
  const Propagation::Way way = merged_.way_to(inner, best);
  return {way.distance, way.source, way, {}};
}

void Fallback::trace(const Way& way, std::vector<SurfacePoint>& out) const {
  if (is_exact_)
    exact_->trace(way.exact, out);
  else
    merged_.trace(way.merged, out);
}

void Fallback::trace_from_vertex(Index vertex, std::vector<SurfacePoint>& out) const {
  if (is_exact_)
    exact_->trace_from_vertex(vertex, out);
  else
    merged_.trace_from_vertex(vertex, out);
}

std::array<Counter, 10> Fallback::counters() const {
  std::array<Counter, 10> all = merged_.counters();
  if (!exact_) return all;
  for (const Counter& counter : exact_->counters())
    for (Counter& mine : all) {
      if (std::string_view(mine.name) != counter.name) continue;
      if (&mine == &all.back())
        mine.value += counter.value;
      else if (is_exact_)
        mine.value = counter.value;
    }
  return all;
}

}  // namespace geodrome::merged_windows
