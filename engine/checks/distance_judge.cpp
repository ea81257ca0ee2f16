// SPDX-License-Identifier: MIT
#include "engine/checks/distance_judge.hpp"

#include <algorithm>
#include <cmath>

#include "engine/checks/lipschitz.hpp"
#include "engine/checks/rounding_scale.hpp"
#include "engine/formats/number_text.hpp"
#include "engine/search/distances.hpp"

namespace geodrome {

DistanceJudge::DistanceJudge(const PreparedSolver& solver, const SurfaceMesh& mesh, const GivenDistances& given)
    : solver_(solver),
      mesh_(mesh),
      given_(given),
      factor_(solver.plugin.factor),
      smallest_weight_(smallest_weight(mesh)) {
  const auto on_surface = [](const NamedPoint& point) { return point.place.state == Place::State::on_surface; };
  for (Index i = 0; i < given.sources.size(); ++i)
    if (on_surface(source(i))) sources_.push_back(i);
  for (Index j = 0; j < given.targets.size(); ++j)
    if (on_surface(target(j)) && solver.states_factor_at(target(j).place)) targets_.push_back(j);
  if (given.rows > 0 && !sources_.empty()) offset_ = source(sources_[0]).start;
  RoundingScale scale(smallest_weight_);
  for (const Distance& distance : given.distances) scale.distances({&distance.value, 1});
  scale_ = scale.points(mesh.positions()).value();
}

bool DistanceJudge::promises_all() const {
  const auto promised = [&](Index i) { return solver_.states_factor_at(source(i).place); };
  return std::isfinite(factor_) && std::ranges::all_of(sources_, promised);
}

/// What the rule makes of a distance at least, whatever the search found: of a cloud the straight line.
double DistanceJudge::least(Index j) const {
  const Index i = given(j).source;
  return given_.targets.bounded() && i < given_.sources.size() ? DistanceRule{true}(0, source(i), target(j)) : 0;
}

bool DistanceJudge::is_worse(double violation) {
  if (std::isnan(violation)) violation = infinity;
  if (violation <= worst_) return false;
  worst_ = violation;
  return true;
}

std::string DistanceJudge::text(double value) { return number_text(value); }

void DistanceJudge::check_straight_lines() {
  // Of several points of a target the closest one counts, but only one is its place.
  if (!given_.targets.one_point_each()) return;
  if (!given_.targets.bounded() && !solver_.provides(Provides::never_shorter)) return;
  for (const Index j : targets_) {
    if (given(j).reach != Reach::reached) continue;
    const bool named = given(j).source < given_.sources.size();
    if (!named) return report(infinity, j, [] { return "no source is named:"; }, given(j).value);
    const NamedPoint& from = source(given(j).source);
    const double straight = smallest_weight_ * distance(from.place.position, target(j).place.position) + from.start;
    const auto whose = [] { return "the straight line with the start distance is"; };
    report(straight - (1 + given_.rounding) * given(j).value, j, whose, straight);
  }
}

void DistanceJudge::check_vertices(std::span<const double> vertices) {
  check_starts(vertices);
  check_targets(vertices);
}

void DistanceJudge::check_starts(std::span<const double> vertices) {
  for (const Index i : sources_)
    for_corners(source(i).place, [&](Index vertex, double way) {
      const double limit = given_.max_distance - offset_, start = source(i).start - offset_;
      if (!is_worse(lipschitz_excess(vertices[vertex], start, way, factor_, limit))) return;
      where_ = "the search found vertex " + std::to_string(vertex) + " at distance " + text(vertices[vertex]) +
               ", but source " + source(i).label + ", which starts at " + text(start) + ", is " + text(way) + " away";
    });
}

void DistanceJudge::check_targets(std::span<const double> vertices) {
  const auto whose = [] { return "by what the search found at a vertex it is"; };
  for (const Index j : targets_)
    for_corners(target(j).place, [&](Index vertex, double way) {
      const double there = vertices[vertex] + offset_;
      not_longer_than(j, there + way, whose);
      if (given_.targets.one_point_each())
        not_shorter_than(j, there - factor_ * way, given_.max_distance - factor_ * way, whose);
    });
}

DistanceAudit DistanceJudge::result() const {
  DistanceAudit result;
  result.scale = scale_, result.where = where_;
  result.worst = scale_ > 0 ? worst_ / scale_ : worst_;
  return result;
}

}  // namespace geodrome
