// SPDX-License-Identifier: MIT
#include "engine/checks/distance_judge.hpp"

#include <cmath>

#include "engine/checks/lipschitz.hpp"
#include "engine/checks/rounding_scale.hpp"
#include "engine/formats/number_text.hpp"
#include "engine/search/distances.hpp"
#include "engine/surface/common_face.hpp"

namespace geodrome {

namespace {

bool on_surface(const NamedPoint& point) { return point.place.state == Place::State::on_surface; }

/// Visits the vertices that a straight way in the place's face leads to, with its cost: of a vertex itself alone.
template <class Visit>
void for_corners(const SurfaceMesh& mesh, const Place& place, Visit&& visit) {
  if (place.vertex != no_index) return visit(place.vertex, 0.0);
  const auto& [face, b] = place.at;
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<double, 3> corner{};
    corner[i] = 1;
    visit(mesh.triangles()[face][i], straight_within(mesh, face, b, corner));
  }
}

}  // namespace

DistanceJudge::DistanceJudge(const PreparedSolver& solver, const SurfaceMesh& mesh, const GivenDistances& given)
    : solver_(solver),
      mesh_(mesh),
      given_(given),
      factor_(solver.plugin.factor),
      smallest_weight_(smallest_weight(mesh)) {
  for (Index i = 0; i < given.sources.size(); ++i)
    if (on_surface(source(i))) sources_.push_back(i);
  for (Index j = 0; j < given.targets.size(); ++j)
    if (on_surface(target(j)) && solver.states_factor_at(target(j).place)) targets_.push_back(j);
  if (given.rows > 0 && !sources_.empty()) offset_ = source(sources_[0]).start;
  RoundingScale scale(smallest_weight_);
  for (const Distance& distance : given.distances) scale.distances({&distance.value, 1});
  scale_ = scale.points(mesh.positions()).value();
}

/// What the rule makes of a distance at least, whatever the search found: of a cloud the straight line.
double DistanceJudge::least(Index j) const {
  const Index i = given(j).source;
  return given_.targets.bounded() && i < given_.sources.size() ? DistanceRule{true}(0, source(i), target(j)) : 0;
}

/// Keeps the worst; a violation that is no number is worse than all.
bool DistanceJudge::is_worse(double violation) {
  if (std::isnan(violation)) violation = infinity;
  if (violation <= worst_) return false;
  worst_ = violation;
  return true;
}

void DistanceJudge::report(double violation, Index j, double other, std::string_view words) {
  if (!is_worse(violation)) return;
  const bool named = given(j).source < given_.sources.size();
  where_ = "target " + target(j).label + " is given " + number_text(given(j).value) +
           (named ? " from source " + source(given(j).source).label : "") + ", but " + std::string(words) + " " +
           number_text(other);
}

void DistanceJudge::not_longer_than(Index j, double other, std::string_view words) {
  const double value = given(j).value, bound = std::max(factor_ * other, least(j));
  if (bound == infinity) return;
  if (value != infinity) return report(value - (1 + given_.rounding) * bound, j, other, words);
  // Beyond the limit: of a cloud the straight line from a source that is not named may be what lies there.
  const bool named = given(j).source < given_.sources.size();
  if (!given_.targets.bounded() || named) report(given_.max_distance - bound, j, other, words);
}

void DistanceJudge::not_shorter_than(Index j, double other, double radius, std::string_view words) {
  const double value = given(j).value, at_least = other == infinity ? radius : other;
  if (value < infinity) report(at_least - (factor_ + given_.rounding) * value, j, other, words);
}

void DistanceJudge::check_straight_lines() {
  // Of several points of a target the closest one counts, but only one is its place.
  if (!given_.targets.one_point_each()) return;
  if (!given_.targets.bounded() && !solver_.provides(Provides::never_shorter)) return;
  for (const Index j : targets_) {
    if (given(j).reach != Reach::reached) continue;
    if (given(j).source >= given_.sources.size()) return report(infinity, j, given(j).value, "no source is named:");
    const NamedPoint& from = source(given(j).source);
    const double straight = smallest_weight_ * distance(from.place.position, target(j).place.position) + from.start;
    report(straight - (1 + given_.rounding) * given(j).value, j, straight,
           "the straight line with the start distance is");
  }
}

void DistanceJudge::check_vertices(std::span<const double> vertices) {
  for (const Index i : sources_)
    for_corners(mesh_, source(i).place, [&](Index vertex, double way) {
      const double limit = given_.max_distance - offset_, start = source(i).start - offset_;
      if (!is_worse(lipschitz_excess(vertices[vertex], start, way, factor_, limit))) return;
      where_ = "the search found vertex " + std::to_string(vertex) + " at distance " + number_text(vertices[vertex]) +
               ", but source " + source(i).label + " is " + number_text(way) + " away";
    });
  constexpr std::string_view words = "by what the search found at a vertex it is";
  for (const Index j : targets_)
    for_corners(mesh_, target(j).place, [&](Index vertex, double way) {
      const double there = vertices[vertex] + offset_;
      not_longer_than(j, there + way, words);
      if (given_.targets.one_point_each())
        not_shorter_than(j, there - factor_ * way, given_.max_distance - factor_ * way, words);
    });
}

DistanceAudit DistanceJudge::result() const {
  DistanceAudit result;
  result.scale = scale_, result.where = where_;
  result.worst = scale_ > 0 ? worst_ / scale_ : worst_;
  return result;
}

}  // namespace geodrome
