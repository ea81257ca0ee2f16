// SPDX-License-Identifier: MIT
#include "engine/checks/nearest_audit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/checks/rounding_scale.hpp"
#include "engine/checks/seeded_subset.hpp"
#include "engine/checks/surface_audit.hpp"
#include "engine/formats/number_text.hpp"
#include "engine/search/distances.hpp"
#include "engine/search/reach.hpp"
#include "engine/surface/face_weight.hpp"

namespace geodrome {

namespace {

constexpr std::size_t fewest_searches = 3;

bool on_surface(const NamedPoint& point) { return point.place.state == Place::State::on_surface; }

class NearestAuditor {
 public:
  NearestAuditor(const PreparedSolver& solver, const SurfaceMesh& mesh, const GivenNearest& given, RunContext& context)
      : solver_(solver), mesh_(mesh), given_(given), context_(context), factor_(solver.plugin.factor) {
    for (Index i = 0; i < given.sources.size(); ++i)
      if (on_surface(given.sources[i])) usable_.push_back(i);
    for (Index j = 0; j < target_count(); ++j)
      if (on_surface(target(j)) && solver_.states_factor_at(target(j).place)) judged_.push_back(j);
    RoundingScale scale(smallest_weight(mesh));
    for (const Distance& distance : given.distances) scale.distances({&distance.value, 1});
    result_.scale = scale.points(mesh.positions()).value();
  }

  NearestAudit run(double share, std::uint64_t seed) {
    if (share <= 0) result_.not_audited = "switched off";
    if (share > 0 && usable_.empty()) result_.not_audited = "no source lies on the surface";
    if (!result_.not_audited.empty()) return result_;
    check_reach();
    check_straight_lines();
    repeat(share, seed);
    if (std::isfinite(factor_)) {
      search_from_sources(share, seed);
      search_from_targets();
    }
    if (result_.scale > 0) result_.worst /= result_.scale;
    if (result_.from_sources + result_.from_targets == 0) result_.not_audited = result_.search_not_audited;
    return result_;
  }

 private:
  Index target_count() const { return static_cast<Index>(given_.targets.size()); }
  const NamedPoint& target(Index j) const { return given_.targets.named()[j]; }

  /// What the rule makes of a distance at least, whatever the search found: of a cloud the straight line.
  double least(Index j) const {
    const Index source = given_.distances[j].source;
    return given_.targets.bounded() && source < given_.sources.size()
               ? DistanceRule{true}(0, given_.sources[source], target(j))
               : 0;
  }

  void report(double violation, Index j, const std::string& what) {
    if (std::isnan(violation)) violation = infinity;
    if (violation <= result_.worst) return;
    result_.worst = violation;
    const Distance& given = given_.distances[j];
    result_.where = "target " + target(j).label + " is given " + number_text(given.value) +
                    (given.source < given_.sources.size() ? " from source " + given_.sources[given.source].label : "") +
                    ", but " + what;
  }

  /// `other` is the length of a way to target j by this solver, at most `factor` times the shortest.
  void not_longer_than(Index j, double other, const std::string& whose) {
    const double given = given_.distances[j].value, bound = std::max(factor_ * other, least(j));
    const std::string what = whose + " " + number_text(other);
    if (!std::isfinite(bound)) return;
    if (std::isfinite(given)) return report(given - bound, j, what);
    // Beyond the limit: of a cloud the straight line may be what lies there.
    if (!given_.targets.bounded()) report(given_.max_distance - bound, j, what);
  }
  /// `other` is what another search gives for the very source that is named.
  void not_shorter_than(Index j, double other, const std::string& whose) {
    const double given = given_.distances[j].value;
    if (std::isfinite(given)) report(other - factor_ * given, j, whose + " " + number_text(other));
  }

  void check_reach() {
    const std::vector<Index> of_source = components_of(mesh_, given_.sources),
                             of_target = components_of(mesh_, given_.targets.named());
    for (Index j = 0; j < target_count(); ++j) {
      if (of_target[j] == no_index) continue;
      const bool joined = std::ranges::find(of_source, of_target[j]) != of_source.end();
      const Distance& given = given_.distances[j];
      const bool allowed = given.reach == Reach::beyond_limit && std::isfinite(given_.max_distance);
      result_.missed += joined && given.reach != Reach::reached && !allowed;
      result_.impossible += !joined && given.reach != Reach::unreachable;
    }
  }

  void check_straight_lines() {
    if (!given_.targets.bounded() && !solver_.provides(Provides::never_shorter)) return;
    for (const Index j : judged_) {
      const Distance& given = given_.distances[j];
      if (given.reach != Reach::reached) continue;
      if (given.source >= given_.sources.size()) return report(infinity, j, "no source is named");
      const NamedPoint& source = given_.sources[given.source];
      const double straight =
          smallest_weight(mesh_) * distance(source.place.position, target(j).place.position) + source.start;
      report(straight - given.value, j, "the straight line with the start distance is " + number_text(straight));
    }
  }

  /// The very search once more, kept as a map.
  void repeat(double share, std::uint64_t seed) {
    if (!solver_.provides(Provides::any_point | Provides::paths)) {
      result_.search_not_audited = solver_.plugin.info.full_name() + " does not provide any_point and paths";
      return;
    }
    std::vector<Source> sources;
    for (const Index i : usable_) sources.push_back({given_.sources[i].place.at, given_.sources[i].start});
    const auto search = make_search(solver_);
    try {
      const ShortestPathMap& map = run_search(solver_, *search, sources, {.keep = Keep::map}, context_);
      cross_boundary(solver_.plugin.info, [&] {
        result_.search =
            audit(mesh_, sources, map, solver_.plugin.info.provides, {.factor = factor_, .share = share, .seed = seed});
        if (std::isfinite(factor_)) compare_with(map);
      });
    } catch (const RefusedError& error) {
      result_.search_not_audited = error.what();
    }
  }

  void compare_with(const ShortestPathMap& map) {
    for (const Index j : judged_) {
      const Distance found = map.at(target(j).place.at);
      not_longer_than(j, found.value, "the same search, made to keep a map, gives");
      not_shorter_than(j, found.value, "the same search, made to keep a map, gives");
    }
  }

  void search_from_sources(double share, std::uint64_t seed) {
    std::vector<Index> chosen;
    for (const Index i : usable_)
      if (solver_.states_factor_at(given_.sources[i].place)) chosen.push_back(i);
    const auto wanted = static_cast<std::size_t>(std::ceil(share * static_cast<double>(chosen.size())));
    const auto search = make_search(solver_);
    std::vector<double> row(given_.targets.size());
    for (const std::size_t k : seeded_subset(chosen.size(), std::max(wanted, fewest_searches), seed)) {
      const Index i = chosen[k];
      const NamedPoint& source = given_.sources[i];
      distance_row(solver_, *search, source, given_.targets, infinity, context_, row);
      const std::string whose = "a search from source " + source.label + " alone gives";
      for (const Index j : judged_) {
        if (std::isfinite(row[j])) not_longer_than(j, row[j], whose);
        if (given_.distances[j].source == i) not_shorter_than(j, row[j], whose);
      }
      ++result_.from_sources;
      context_.throw_if_cancelled();
    }
    result_.targets = result_.from_sources > 0 ? judged_.size() : 0;
  }

  /// The farthest targets first: what is lost on the way shows there.
  std::vector<Index> far_targets() const {
    std::vector<Index> reached;
    for (const Index j : judged_)
      if (given_.distances[j].reach == Reach::reached && solver_.takes_source_at(target(j).place)) reached.push_back(j);
    const auto farther = [&](Index a, Index b) { return given_.distances[a].value > given_.distances[b].value; };
    std::ranges::stable_sort(reached, farther);
    if (reached.size() <= fewest_searches) return reached;
    return {reached.front(), reached[reached.size() / 3], reached[2 * reached.size() / 3]};
  }

  void search_from_targets() {
    const auto can_be_asked = [&](Index i) {
      const Place& place = given_.sources[i].place;
      return solver_.states_factor_at(place) && solver_.answers_at(place);
    };
    if (!std::ranges::all_of(usable_, can_be_asked)) return;
    std::vector<SurfacePoint> ends;
    for (const Index i : usable_) ends.push_back(given_.sources[i].place.at);
    const auto search = make_search(solver_);
    for (const Index j : far_targets()) {
      const Source from{target(j).place.at, 0};
      const ShortestPathMap& map = run_search(solver_, *search, {&from, 1}, {.targets = ends}, context_);
      for (std::size_t k = 0; k < ends.size(); ++k) {
        const Index i = usable_[k];
        const double back =
            cross_boundary(solver_.plugin.info, [&] { return map.at(ends[k]).value; }) + given_.sources[i].start;
        const std::string whose = "the way back to source " + given_.sources[i].label + " has with its start distance";
        if (std::isfinite(back)) not_longer_than(j, back, whose);
        if (given_.distances[j].source == i) not_shorter_than(j, back, whose);
      }
      ++result_.from_targets;
      context_.throw_if_cancelled();
    }
  }

  const PreparedSolver& solver_;
  const SurfaceMesh& mesh_;
  const GivenNearest& given_;
  RunContext& context_;
  double factor_;
  std::vector<Index> usable_, judged_;  // sources on the surface; targets there of which the factor is promised
  NearestAudit result_;
};

}  // namespace

std::vector<std::string> broken_promises(const NearestAudit& audit) {
  std::vector<std::string> broken;
  if (audit.missed > 0) broken.push_back(std::to_string(audit.missed) + " targets beside a source are not reached");
  if (audit.impossible > 0)
    broken.push_back(std::to_string(audit.impossible) + " targets are reached that no source can reach");
  if (std::max(audit.search.worst_lipschitz, audit.search.worst_path) > audit_tolerance)
    broken.push_back("the audit failed: from all sources at once: " + audit.search.where);
  if (audit.worst > audit_tolerance) broken.push_back("the audit failed: " + audit.where);
  return broken;
}

NearestAudit audit_nearest(const PreparedSolver& solver, const SurfaceMesh& mesh, const GivenNearest& given,
                           double share, std::uint64_t seed, RunContext& context) {
  return NearestAuditor(solver, mesh, given, context).run(share, seed);
}

}  // namespace geodrome
