// SPDX-License-Identifier: MIT
#include "engine/search/nearest_sources.hpp"

#include <algorithm>

namespace geodrome {

namespace {

/// Hands on everything but progress, of which the search from all sources was the larger part.
class AfterProgress final : public RunContext {
 public:
  explicit AfterProgress(RunContext& context) : context_(context) {}
  void progress(double) override {}
  bool cancelled() const noexcept override { return context_.cancelled(); }
  void log(LogLevel level, std::string_view message) override { context_.log(level, message); }
  void measure(std::string_view name, double value) override { context_.measure(name, value); }
  unsigned threads() const noexcept override { return context_.threads(); }
  std::uint64_t seed() const noexcept override { return context_.seed(); }

 private:
  RunContext& context_;
};

/// What is known of the targets, as sources are compared one after the other.
class Contest {
 public:
  Contest(std::span<const NamedPoint> sources, const TargetList& targets, double max_distance, MeasuredNearest& nearest)
      : sources_(sources), targets_(targets), max_distance_(max_distance), nearest_(nearest) {}

  /// How far to search around source `i` on the triangles, its start distance included; 0 if it is nearest to nothing
  /// but what it is known to be nearest to.
  double reach(Index i) {
    open_.clear();
    double farthest = 0;
    const NamedPoint& source = sources_[i];
    for (std::size_t j = 0; j < targets_.size(); ++j) {
      const Distance& flat = nearest_.flat[j];
      const Place& place = targets_.named()[j].place;
      if (flat.reach != Reach::reached || flat.source == i || place.state != Place::State::on_surface) continue;
      if (source.start + distance(source.place.position, place.position) >= known(j)) continue;
      open_.push_back(j);
      farthest = std::max(farthest, known(j) - source.start);
    }
    return open_.empty() ? 0 : source.start + farther_for_smooth * farthest;
  }

  /// Leaves in a row on the triangles what may be shorter on the smooth surface than what is known.
  bool leave_open(Index i, std::span<double> row) const {
    bool any = false;
    const double start = sources_[i].start;
    std::vector<double> left(row.size(), infinity);
    for (const std::size_t j : open_)
      if (row[j] - start < farther_for_smooth * (known(j) - start)) left[j] = row[j], any = true;
    std::ranges::copy(left, row.begin());
    return any;
  }

  void take(Index i, std::span<const double> smooth) {
    for (const std::size_t j : open_)
      if (smooth[j] < known(j)) nearest_.distances[j] = {smooth[j], Reach::reached, i};
  }

 private:
  double known(std::size_t j) const {
    const Distance& found = nearest_.distances[j];
    return found.reach == Reach::reached ? found.value : max_distance_;
  }

  std::span<const NamedPoint> sources_;
  const TargetList& targets_;
  double max_distance_;
  MeasuredNearest& nearest_;
  std::vector<std::size_t> open_;  // targets that the source may be nearest to
};

}  // namespace

void compare_sources(const PreparedSolver& solver, std::span<const NamedPoint> sources, const TargetList& targets,
                     double max_distance, RunContext& context, MeasuredNearest& nearest) {
  AfterProgress within(context);
  const auto search = make_search(solver);
  Contest contest(sources, targets, max_distance, nearest);
  std::vector<double> row(targets.size());
  for (Index i = 0; i < sources.size(); ++i) {
    context.throw_if_cancelled();
    if (sources[i].place.state != Place::State::on_surface) continue;
    double reach = contest.reach(i);
    if (!(reach > 0)) continue;
    reach = solver.provides(Provides::radius_limit) ? reach + solver.smooth->around : infinity;
    const ShortestPathMap* map = distance_row(solver, *search, sources[i], targets, reach, within, row, Keep::map);
    ++nearest.compared;
    if (!contest.leave_open(i, row)) continue;
    nearest.smooth->add(smooth_row(solver, *map, sources[i], targets, max_distance, row));
    contest.take(i, row);
  }
}

}  // namespace geodrome
