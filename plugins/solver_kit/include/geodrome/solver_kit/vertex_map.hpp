// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "geodrome/solver_kit/request_checks.hpp"
#include "geodrome/solver_kit/source_components.hpp"

namespace geodrome {

/// The map of a solver that knows the distances of vertices alone, and no paths. Reused from run to run; forgetting a
/// run costs what it reached. One per search.
class VertexMap final : public ShortestPathMap {
 public:
  /// `components` names the component of every vertex (vertex_components). Both are kept by reference.
  VertexMap(const SurfaceMesh& mesh, const std::vector<Index>& components)
      : mesh_(mesh),
        components_(components),
        distances_(mesh.vertex_count(), infinity),
        sources_(mesh.vertex_count(), no_index) {}

  /// Forgets the last run and takes the sources of the next. Throws as require_valid, and CapabilityError for a target
  /// that is no vertex. O(what the last run reached).
  void begin(std::span<const Source> sources, const Request& request) {
    require_valid(mesh_, sources, request);
    for (const SurfacePoint& target : request.targets) vertex_of(target);
    for (const Index v : reached_) distances_[v] = infinity, sources_[v] = no_index;
    reached_.clear();
    with_source_.assign(mesh_, components_, sources);
  }

  /// Sets the distance of a vertex, and the source it is from, if the new distance is shorter.
  void lower(Index vertex, double distance, Index source) {
    if (!(distance < distances_[vertex])) return;
    if (sources_[vertex] == no_index) reached_.push_back(vertex);
    distances_[vertex] = distance, sources_[vertex] = source;
  }

  /// Returns the vertex that a point is at. Throws CapabilityError for a point that is no vertex.
  Index vertex_of(const SurfacePoint& point) const {
    const Index vertex = mesh_.vertex_at(point);
    if (vertex == no_index)
      throw CapabilityError("distances are known at vertices only", "choose a solver that provides any_point");
    return vertex;
  }

  std::span<const double> vertices() const override { return distances_; }

  Distance at(const SurfacePoint& point) const override {
    require_on_surface(mesh_, point, "the point");
    const Index vertex = vertex_of(point);
    if (sources_[vertex] != no_index) return {distances_[vertex], Reach::reached, sources_[vertex]};
    return {distances_[vertex], with_source_.contains(components_[vertex]) ? Reach::beyond_limit : Reach::unreachable,
            no_index};
  }

  void path(const SurfacePoint&, std::vector<SurfacePoint>&) const override {
    throw CapabilityError("paths are not supported", "choose a solver that provides paths");
  }

  /// Sets what `counters()` returns: figures of the run, kept by the search, which outlives the map.
  void count(std::span<const Counter> counters) { counters_ = counters; }
  std::span<const Counter> counters() const override { return counters_; }
  std::size_t bytes() const {
    return distances_.size() * (sizeof(double) + sizeof(Index)) + reached_.capacity() * sizeof(Index);
  }

 private:
  const SurfaceMesh& mesh_;
  const std::vector<Index>& components_;
  SourceComponents with_source_;
  std::vector<double> distances_;
  std::vector<Index> sources_, reached_;
  std::span<const Counter> counters_;
};

}  // namespace geodrome
