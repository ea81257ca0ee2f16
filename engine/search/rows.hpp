// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "engine/host/stage_context.hpp"
#include "engine/search/counter_sum.hpp"
#include "engine/search/smooth_distances.hpp"
#include "engine/search/source_surface.hpp"
#include "geodrome/engine/row_set.hpp"
#include "geodrome/engine/row_sink.hpp"

namespace geodrome {

/// Tells an observer everything but progress: progress is told per row, not within one.
class WithoutProgress final : public Observer {
 public:
  explicit WithoutProgress(Observer& observer) : observer_(observer) {}
  void log(LogLevel level, std::string_view message) override { observer_.log(level, message); }
  std::string words(const Remedy& remedy) const override { return observer_.words(remedy); }
  bool cancelled() const noexcept override { return observer_.cancelled(); }

 private:
  Observer& observer_;
};

/// Is told of the search of source `i`: its surface, the map, which started at 0, and the row on the triangles. Called
/// from several threads at once.
using WatchRows = std::function<void(std::uint64_t i, const SourceSurface& on, const ShortestPathMap& map,
                                     std::span<const double> flat)>;

/// What is wanted beside the distances.
struct RowExtras {
  bool bounds = false;  ///< each row is followed by that of its lower bounds: see `read_lower_bounds`
  WatchRows watch;      ///< may be empty
  /// Whether `watch` looks at the row of source i; else only the distances of vertices need be in it. Empty: always.
  std::function<bool(std::uint64_t i)> looks_at_row;
};

/// Makes single rows of distances, each from one source to all targets, on whatever surface the rule gives the source:
/// smooth ones where the solver has a smooth metric. Thread-safe.
class RowMaker {
 public:
  /// All must outlive it. `solver` has the reconstruction of `surfaces` prepared.
  RowMaker(const PreparedSolver& solver, const SourceSurfaces& surfaces, std::span<const NamedPoint> sources,
           double max_distance, std::uint64_t seed, Observer& observer, RowExtras extras = {});

  /// Numbers in a row, bounds included.
  std::size_t columns() const { return (extras_.bounds ? 2 : 1) * surfaces_.targets().size(); }
  const PreparedSolver& solver() const { return solver_; }

  /// Fills the row of source `i`. `search`: on the reconstruction, by the solver or by what it planned. Throws as
  /// `distance_row`.
  void make(Search& search, std::uint64_t i, std::span<double> row);

  /// The counters of all searches so far.
  std::map<std::string, std::uint64_t> counters() const { return counters_.sums(); }
  /// What became of the flat paths of all rows so far, added up in the order of the rows; none without a smooth metric.
  std::optional<SmoothFigures> smooth() const;
  /// Counts the sources so far by the way in which they became vertices; empty for `project`.
  std::map<std::string, std::uint64_t> insertions() const;

 private:
  void measure(const PreparedSolver& solver, Search& search, std::uint64_t i, const SourceSurface& on,
               std::span<double> row);

  const PreparedSolver& solver_;
  const SourceSurfaces& surfaces_;
  std::span<const NamedPoint> sources_;
  double max_distance_;
  WithoutProgress quiet_;
  StageContext context_;
  RowExtras extras_;
  CounterSum counters_;
  std::array<std::atomic<std::uint64_t>, 4> insertions_{};
  std::vector<SmoothFigures> smooth_;  // per row; none without a smooth metric
};

/// Makes the rows of the set that the sink has not, over at most `threads` threads, each with a search of its own by
/// `solver`: the maker's, or with the surface for a plan (`prepare_plan`). Row 0 is by the maker's own either way, as
/// that of a job, which times it before there is a plan. Throws as `fill_rows` and `distance_row`.
void compute_rows(const RowSet& rows, const PreparedSolver& solver, RowMaker& maker, RowSink& sink, unsigned threads,
                  RunContext& context);

}  // namespace geodrome
