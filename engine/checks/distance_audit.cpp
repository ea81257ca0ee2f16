// SPDX-License-Identifier: MIT
#include "engine/checks/distance_audit.hpp"

#include <algorithm>
#include <cmath>

#include "engine/checks/distance_judge.hpp"
#include "engine/checks/invariants.hpp"
#include "engine/checks/lipschitz.hpp"
#include "engine/checks/seeded_subset.hpp"
#include "engine/search/distances.hpp"
#include "engine/search/reach.hpp"

namespace geodrome {

namespace {

constexpr std::size_t fewest_searches = 3;

/// The part of the faces that is searched with a map, over the part that is audited: near the sources windows are few,
/// on smooth surfaces as the power 1.5 of the part, and a map of them all takes far more memory than the job.
constexpr double mapped_per_audited = 4;

/// Searches without a map may reach this part of the faces a row or source of the job, so that each costs at most this
/// part of what the job's searches did.
constexpr double searched_part = 0.01;

/// Either part holds so many faces, or all there are: they cost next to nothing.
constexpr std::size_t fewest_faces = 1000;

/// A search back from a target looks so much farther than it should have to.
constexpr double farther_back = 1.1;

class DistanceAuditor {
 public:
  DistanceAuditor(const PreparedSolver& solver, const SurfaceMesh& mesh, const GivenDistances& given,
                  RunContext& context)
      : solver_(solver),
        mesh_(mesh),
        given_(given),
        context_(context),
        factor_(solver.plugin.factor),
        judge_(solver, mesh, given),
        component_(vertex_components(mesh)),
        has_source_(mesh.vertex_count()),
        search_(make_search(solver)) {
    for (const NamedPoint& one : given_.sources)
      if (const Index c = component_of(mesh_, component_, one.place); c != no_index) has_source_[c] = true;
    const auto promised = [&](Index i) { return solver.states_factor_at(judge_.source(i).place); };
    promised_ = std::isfinite(factor_) && std::ranges::all_of(judge_.sources(), promised);
  }

  DistanceAudit run(double share, std::uint64_t seed) {
    if (given_.rows == 0) check_reach();
    judge_.check_straight_lines();
    find_vertices();
    if (promised_) judge_.check_vertices(vertices_);
    repeat(share, seed);
    if (std::isfinite(factor_)) {
      if (given_.rows == 0) search_from_sources(share, seed);
      search_from_targets();
    }
    result_.add(judge_.result());
    // Those of a row were audited when they were found (RowAudit::hear).
    if (promised_ && (given_.rows == 0 || given_.vertices.empty()))
      result_.add(audit_vertices(mesh_, vertices_, factor_, limit(), all_sources(), "the same sources"));
    if (!std::isfinite(factor_)) result_.not_audited = result_.search_not_audited;
    return result_;
  }

 private:
  double limit() const { return given_.max_distance - judge_.offset(); }

  std::vector<Source> all_sources() const {
    std::vector<Source> sources;
    for (const Index i : judge_.sources())
      sources.push_back({judge_.source(i).place.at, judge_.source(i).start - judge_.offset()});
    return sources;
  }

  void check_reach() {
    for (Index j = 0; j < given_.targets.size(); ++j) {
      const Index c = component_of(mesh_, component_, judge_.target(j).place);
      if (c == no_index) continue;
      const Reach reach = judge_.given(j).reach;
      const bool allowed = reach == Reach::beyond_limit && std::isfinite(given_.max_distance);
      result_.missed += has_source_[c] && reach != Reach::reached && !allowed;
      result_.impossible += !has_source_[c] && reach != Reach::unreachable;
    }
  }

  void find_vertices() {
    vertices_ = given_.vertices;
    if (!vertices_.empty()) return;
    const Request request{.radius = limit(), .targets = given_.targets.points()};
    const ShortestPathMap& map = run_search(solver_, *search_, all_sources(), request, context_);
    cross_boundary(solver_.plugin.info, [&] { found_.assign(map.vertices().begin(), map.vertices().end()); });
    vertices_ = found_;
  }

  /// The radius within which the wanted part of the faces lies, as far as the search reached; +inf where the solver
  /// cannot stop there.
  double radius_of(double part) {
    if (!std::isfinite(factor_) || !solver_.provides(Provides::radius_limit)) return infinity;
    if (bounds_.empty()) bounds_ = bounds_of_faces(mesh_, vertices_);
    std::vector<double> reached;
    for (const double bound : bounds_)
      if (bound < infinity) reached.push_back(bound);
    if (reached.empty()) return 0;
    const auto of_part = static_cast<std::size_t>(std::min(part, 1.0) * static_cast<double>(mesh_.face_count()));
    const auto last = std::clamp(of_part, std::min(fewest_faces, reached.size()), reached.size()) - 1;
    std::ranges::nth_element(reached, reached.begin() + static_cast<std::ptrdiff_t>(last));
    return reached[last];
  }

  /// What a solver must be asked for so that nothing within the radius is missing.
  double asked(double radius) const { return factor_ * (1 + float64_tolerance) * radius; }

  /// All faces within the radius, and those that no source reaches.
  std::vector<Index> faces_within(double radius) const {
    std::vector<Index> faces;
    for (Index face = 0; radius < infinity && face < mesh_.face_count(); ++face)
      if (bounds_[face] <= radius || !has_source_[component_[mesh_.triangles()[face][0]]]) faces.push_back(face);
    return faces;
  }

  /// The very search once more, kept as a map.
  void repeat(double share, std::uint64_t seed) {
    if (!solver_.provides(Provides::any_point | Provides::paths)) {
      result_.search_not_audited = solver_.plugin.info.full_name() + " does not provide any_point and paths";
      return;
    }
    const std::vector<Source> sources = all_sources();
    const double radius = radius_of(mapped_per_audited * share);
    const std::vector<Index> faces = faces_within(radius);
    try {
      const Request request{.radius = asked(radius), .targets = given_.targets.points(), .keep = Keep::map};
      const ShortestPathMap& map = run_search(solver_, *search_, sources, request, context_);
      cross_boundary(solver_.plugin.info, [&] {
        std::vector<double> row(given_.targets.size());
        for (const Index j : judge_.targets()) row[j] = given_.targets.read(map, j) + judge_.offset();
        if (promised_) hold(row, radius + judge_.offset(), no_index, "the same search, made to keep a map, gives");
        if (radius < infinity && faces.empty()) return;
        result_.search =
            audit(mesh_, sources, map, solver_.plugin.info.provides,
                  {.factor = factor_, .share = share, .faces = faces, .seed = seed, .scale = judge_.scale()});
      });
    } catch (const RefusedError& error) {
      result_.search_not_audited = error.what();
    }
  }

  /// What another search gave, which looked no farther than `radius`: from all sources, or from `alone`.
  void hold(std::span<const double> row, double radius, Index alone, std::string_view words) {
    for (const Index j : judge_.targets()) {
      judge_.not_longer_than(j, row[j], words);
      if (alone == no_index || judge_.given(j).source == alone) judge_.not_shorter_than(j, row[j], radius, words);
    }
  }

  void search_from_sources(double share, std::uint64_t seed) {
    std::vector<Index> chosen;
    for (const Index i : judge_.sources())
      if (solver_.states_factor_at(judge_.source(i).place)) chosen.push_back(i);
    const bool whole = mapped_per_audited * share >= 1;
    const auto of_share = static_cast<std::size_t>(std::ceil(share * static_cast<double>(chosen.size())));
    const double radius = radius_of(searched_part * static_cast<double>(judge_.sources().size()));
    std::vector<double> row(given_.targets.size());
    for (const std::size_t k :
         seeded_subset(chosen.size(), whole ? std::max(of_share, fewest_searches) : fewest_searches, seed)) {
      const NamedPoint& source = judge_.source(chosen[k]);
      distance_row(solver_, *search_, source, given_.targets, asked(radius), context_, row);
      hold(row, radius, chosen[k], "a search from source " + source.label + " alone gives");
      ++result_.from_sources;
      context_.throw_if_cancelled();
    }
    result_.targets = result_.from_sources > 0 ? judge_.targets().size() : 0;
  }

  /// The farthest targets within the radius: what is lost on the way shows there.
  std::vector<Index> far_targets(double radius) const {
    std::vector<std::pair<double, Index>> reached;
    for (const Index j : judge_.targets()) {
      const Distance& given = judge_.given(j);
      const bool within = given.reach == Reach::reached && given.value - judge_.offset() <= radius;
      if (within && solver_.takes_source_at(judge_.target(j).place)) reached.push_back({given.value, j});
    }
    std::vector<Index> far;
    const std::size_t wanted = std::min(given_.rows > 0 ? 1 : fewest_searches, reached.size());
    for (std::size_t k = 0; k < wanted; ++k) {
      const std::size_t rank = reached.size() - 1 - k * reached.size() / wanted;
      std::ranges::nth_element(reached, reached.begin() + static_cast<std::ptrdiff_t>(rank));
      far.push_back(reached[rank].second);
    }
    return far;
  }

  void search_from_targets() {
    const auto can_be_asked = [&](Index i) {
      const Place& place = judge_.source(i).place;
      return solver_.states_factor_at(place) && solver_.answers_at(place);
    };
    if (!std::ranges::all_of(judge_.sources(), can_be_asked) || !given_.targets.one_point_each()) return;
    const double part = searched_part * static_cast<double>(std::max(given_.rows, judge_.sources().size()));
    for (const Index j : far_targets(radius_of(part))) search_back(j);
  }

  /// From a target to all sources that may be the nearest.
  void search_back(Index j) {
    std::vector<SurfacePoint> ends;
    for (const Source& source : all_sources()) ends.push_back(source.at);
    const Source from{judge_.target(j).place.at, 0};
    const bool limited = solver_.provides(Provides::radius_limit);
    const double radius = limited ? farther_back * (judge_.given(j).value - judge_.offset()) : infinity;
    const Request request{.radius = asked(radius), .targets = ends};
    const ShortestPathMap& map = run_search(solver_, *search_, {&from, 1}, request, context_);
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const Index i = judge_.sources()[k];
      const NamedPoint& source = judge_.source(i);
      const double back = cross_boundary(solver_.plugin.info, [&] { return map.at(ends[k]).value; }) + source.start;
      const double ruled = DistanceRule{given_.targets.bounded()}(back, source, judge_.target(j));
      const std::string words = "the way back to source " + source.label + " has with its start distance";
      judge_.not_longer_than(j, ruled, words);
      if (judge_.given(j).source == i) judge_.not_shorter_than(j, ruled, radius + source.start, words);
    }
    ++result_.from_targets;
    context_.throw_if_cancelled();
  }

  const PreparedSolver& solver_;
  const SurfaceMesh& mesh_;
  const GivenDistances& given_;
  RunContext& context_;
  double factor_;
  DistanceJudge judge_;
  bool promised_;                 // the factor holds for all that the very search found at vertices
  std::vector<Index> component_;  // of every vertex; which of them have a source
  std::vector<bool> has_source_;
  std::unique_ptr<Search> search_;
  std::span<const double> vertices_;    // what the very search found there
  std::vector<double> found_, bounds_;  // the same if it was searched again; bounds of the points of faces
  DistanceAudit result_;
};

}  // namespace

DistanceAudit audit_distances(const PreparedSolver& solver, const SurfaceMesh& mesh, const GivenDistances& given,
                              double share, std::uint64_t seed, RunContext& context) {
  const auto on_surface = [](const NamedPoint& source) { return source.place.state == Place::State::on_surface; };
  if (share <= 0) return {.not_audited = "switched off"};
  if (std::ranges::none_of(given.sources, on_surface)) return {.not_audited = "no source lies on the surface"};
  return DistanceAuditor(solver, mesh, given, context).run(share, seed);
}

}  // namespace geodrome
