// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "plugins/common/exact/propagation_search.hpp"
#include "plugins/solver_merged_windows/fallback.hpp"
#include "plugins/solver_merged_windows/settings.hpp"

namespace geodrome::merged_windows {

/// The search of this plugin: a propagation's, which answers D, with l beside it. With Value::middle it answers the
/// middle of both: at a vertex of its l and D, at any other point of D over the factor of the run and D, since l holds
/// at vertices only. The map that `run` returns is the search itself. The middle costs O(V) a run.
class BoundedSearch final : public Search, private ShortestPathMap {
 public:
  BoundedSearch(std::shared_ptr<const PackedMesh> surface, const Settings& settings);

  /// The search that returned a map.
  static const BoundedSearch& of(const ShortestPathMap& map) { return static_cast<const BoundedSearch&>(map); }

  const ShortestPathMap& run(std::span<const Source> sources, const Request& request, RunContext& context) override;

  /// Those of the extension LowerBounds.
  void write_lower_bounds(std::span<double> bounds) const;
  double lower_bound_at(const SurfacePoint& point) const;

 private:
  std::span<const double> vertices() const override { return is_middle() ? middles_ : upper_->vertices(); }
  Distance at(const SurfacePoint& point) const override;
  void path(const SurfacePoint& point, std::vector<SurfacePoint>& out) const override;
  std::span<const Counter> counters() const override { return upper_->counters(); }

  bool is_middle() const { return settings_.value == Value::middle; }
  void write_middles();

  std::shared_ptr<const PackedMesh> surface_;
  Settings settings_;
  PropagationSearch<Fallback> search_;
  const ShortestPathMap* upper_ = nullptr;  // of the last run
  double radius_ = 0;
  std::vector<double> middles_;
};

}  // namespace geodrome::merged_windows
