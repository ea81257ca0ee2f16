// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "common/solvers/flat_surface.hpp"
#include "common/solvers/query_points.hpp"
#include "common/solvers/vertex_components.hpp"
#include "solver_chen_han/propagation.hpp"

namespace geodrome::chen_han {

/// A search and its map: translates between the request, in the mesh's own numbers and units, and the propagation.
class WindowSearch final : public Search, private ShortestPathMap {
 public:
  WindowSearch(std::shared_ptr<const FlatSurface> surface, const Settings& settings);

  const ShortestPathMap& run(std::span<const Source> sources, const Request& request, RunContext& context) override;

 private:
  std::span<const double> vertices() const override { return distances_; }
  Distance at(const SurfacePoint& point) const override;
  void path(const SurfacePoint& point, std::vector<SurfacePoint>& out) const override;
  std::span<const Counter> counters() const override { return counters_; }

  /// The shortest way to a point that is no vertex, in the units of the flat surface; the last member that is set says
  /// how it begins: through a window, through a corner, or straight from the source.
  struct Way {
    double distance, x = 0, y = 0;
    Index source = no_index, corner = no_index, window = no_index;
  };

  const SurfaceMesh& mesh() const { return surface_->mesh(); }
  void watch(const Request& request);
  double farthest_target(const Request& request) const;
  void finish(const Request& request);
  void count();
  Way plain_way(const SurfacePoint& inner) const;
  Way way_to(const SurfacePoint& point) const;
  Distance judge(double distance, Index source, Index face) const;
  Distance distance_at(const SurfacePoint& point) const;

  std::shared_ptr<const FlatSurface> surface_;
  Propagation propagation_;
  std::vector<Source> sources_;
  std::vector<std::pair<SurfacePoint, Index>> sources_in_faces_;  // inner name, source; by face
  SourceComponents with_source_;
  double limit_ = 0;  // in the units of the flat surface
  double radius_ = 0;
  Keep keep_ = Keep::targets;
  KeptTargets kept_;
  std::vector<double> distances_;
  std::vector<Index> written_;
  std::array<Counter, 8> counters_{};
};

}  // namespace geodrome::chen_han
