// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "geodrome/solver_kit/kept_search.hpp"
#include "plugins/solver_chen_han/rows/direct_lists.hpp"
#include "plugins/solver_chen_han/rows/row_labels.hpp"

namespace geodrome::chen_han {

/// What the searches of a plan share. Immutable.
struct RowTables {
  std::shared_ptr<const PackedMesh> surface;
  Settings settings;
  DirectGround ground;
  DirectLists lists;
  std::vector<bool> is_source;  ///< of vertices
  double distance;              ///< that the lists are complete up to, in units of the packed mesh

  std::size_t bytes() const { return ground.bytes() + lists.bytes + is_source.size() / 8; }
};

/// A search from one vertex at a time by lists of direct paths. Costs O(V) memory; a run costs a direct search from the
/// source unless it has a list, and what RowLabels costs.
class RowSearch final : public KeptSearch {
 public:
  explicit RowSearch(std::shared_ptr<const RowTables> tables);

  /// Tells whether `run` may be called for a request: it wants vertices alone, from a source of the plan, no farther
  /// than the plan says.
  bool can_run(std::span<const Source> sources, const Request& request) const;

 private:
  std::span<const double> vertices() const override { return distances_; }
  std::span<const Counter> counters() const override { return counters_; }
  void search(const Request& request, RunContext& context) override;
  Distance distance_at(const SurfacePoint& point) const override;
  void trace(const SurfacePoint&, const Distance&, std::vector<SurfacePoint>&) const override {}  // never asked for

  double farthest_target(const Request& request) const;
  void write_distances();
  void count(bool searched);

  std::shared_ptr<const RowTables> tables_;
  const PackedMesh& surface_;
  DirectSearch direct_;
  RowLabels labels_;
  double limit_ = 0;  ///< in units of the packed mesh
  std::vector<double> distances_;
  std::vector<Index> written_;
  std::array<Counter, 10> counters_{};
};

}  // namespace geodrome::chen_han
