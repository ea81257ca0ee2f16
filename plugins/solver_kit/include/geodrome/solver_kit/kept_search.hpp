// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "geodrome/shortest_path_solver.hpp"
#include "geodrome/solver_kit/kept_targets.hpp"
#include "geodrome/solver_kit/request_checks.hpp"
#include "geodrome/solver_kit/source_components.hpp"

namespace geodrome {

/// The base of a search that knows distances at any point while it runs and keeps those of vertices and targets
/// afterwards. It checks requests and points, keeps the targets, tells unreachable points from those beyond a limit,
/// and hands the rest to a solver's own class, which implements `search`, `distance_at` and `trace`, and `vertices` and
/// `counters` of ShortestPathMap. Reused from run to run; one per thread.
class KeptSearch : public Search, protected ShortestPathMap {
 public:
  /// Checks the request and runs it: O(s log s + t log t) for s sources and t targets beside the search. Throws
  /// InputError and CapabilityError as require_valid and the solver's `refuse` do, Cancelled, and what `search` throws.
  const ShortestPathMap& run(std::span<const Source> sources, const Request& request, RunContext& context) final {
    require_valid(mesh_, sources, request);
    refuse(sources, request);
    context.throw_if_cancelled();
    sources_.assign(sources.begin(), sources.end());
    radius_ = request.radius;
    keep_ = request.keep;
    with_source_.assign(mesh_, components_, sources_);
    search(request, context);
    if (keep_ == Keep::map)
      kept_.clear();  // any point may be asked, and is searched when it is
    else
      kept_.assign(request.targets, [this](const SurfacePoint& target) { return target_distance(target); });
    finish();
    return *this;
  }

 protected:
  /// `components` names the component of every vertex (vertex_components). Both are kept by reference.
  KeptSearch(const SurfaceMesh& mesh, const std::vector<Index>& components) : mesh_(mesh), components_(components) {}

  /// Throws CapabilityError for a valid request that the solver does not support. Called before anything changes.
  virtual void refuse(std::span<const Source> /*sources*/, const Request& /*request*/) const {}
  /// Searches from `sources()`. What an earlier run left, also one that threw, is forgotten first.
  virtual void search(const Request& request, RunContext& context) = 0;
  /// Returns the distance at a vertex, or, with Keep::map or before `finish`, at any point. The point is on the mesh.
  virtual Distance distance_at(const SurfacePoint& point) const = 0;
  /// Returns the distance at a target of the request, right after `search`, with Keep::targets.
  virtual Distance target_distance(const SurfacePoint& target) const { return distance_at(target); }
  /// Called when the targets are kept: the rest may be dropped unless the request says Keep::map.
  virtual void finish() {}
  /// Appends a path to `out`, which is empty, from a point that has been reached at this distance. Keep::map holds.
  virtual void trace(const SurfacePoint& point, const Distance& distance, std::vector<SurfacePoint>& out) const = 0;

  const SurfaceMesh& mesh() const { return mesh_; }
  const std::vector<Source>& sources() const { return sources_; }
  double radius() const { return radius_; }
  Keep keep() const { return keep_; }

  /// Returns the answer for a point of a face without a distance: beyond the limit if the component of the face holds a
  /// source, else unreachable.
  Distance no_distance(Index face) const {
    const bool can_be_reached = shares_component_with_source(mesh_.triangles()[face][0]);
    return {infinity, can_be_reached ? Reach::beyond_limit : Reach::unreachable, no_index};
  }
  bool shares_component_with_source(Index vertex) const { return with_source_.contains(components_[vertex]); }

 private:
  Distance at(const SurfacePoint& point) const final {
    require_on_surface(mesh_, point, "the point");
    return keep_ == Keep::map || mesh_.vertex_at(point) != no_index ? distance_at(point) : kept_.at(point);
  }

  void path(const SurfacePoint& point, std::vector<SurfacePoint>& out) const final {
    require_on_surface(mesh_, point, "the point");
    require_paths(keep_);
    out.clear();
    const Distance distance = distance_at(point);
    if (distance.reach == Reach::reached) trace(point, distance, out);
  }

  const SurfaceMesh& mesh_;
  const std::vector<Index>& components_;
  std::vector<Source> sources_;
  SourceComponents with_source_;
  KeptTargets kept_;
  double radius_ = 0;
  Keep keep_ = Keep::targets;
};

}  // namespace geodrome
