// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "engine/search/printed_rule.hpp"
#include "engine/search/target_list.hpp"
#include "engine/surface/opened.hpp"
#include "geodrome/engine/distances.hpp"

namespace geodrome {

/// The surface on which the distances from one source are measured, and where source and targets lie on it.
struct SourceSurface {
  MeshPtr mesh;
  NamedPoint source;
  std::shared_ptr<const TargetList> targets;
  Insertion how = Insertion::existing;
};

/// Gives every source its surface, by the query rule: for `project` always the reconstruction, for `insert` and
/// `printed` S_conf + s_src (Algorithm 2, lines 9 and 10). Immutable; thread-safe.
class SourceSurfaces {
 public:
  /// `opened` must outlive it. Precondition: `check_rule` passed.
  SourceSurfaces(ProjectionRule rule, const Opened& opened, std::vector<NamedPoint> targets);

  ProjectionRule rule() const noexcept { return rule_; }
  const MeshPtr& reconstruction() const noexcept { return opened_.surface.mesh; }
  /// The targets on the reconstruction.
  const TargetList& targets() const noexcept { return *targets_; }

  /// A source that lies on no surface gets the reconstruction. Throws what the inserter throws, and PluginError for a
  /// surface that breaks its interface. O(1) for `project`, else the insertion and O(F + targets).
  SourceSurface of(const NamedPoint& source) const;

 private:
  Inserted insert(Index element) const;
  std::shared_ptr<const TargetList> inserted_targets(const SourceSurface& on, Index element) const;
  std::shared_ptr<const TargetList> printed_targets(const SourceSurface& on, Index element) const;
  Index element_of(const NamedPoint& point) const;

  ProjectionRule rule_;
  const Opened& opened_;
  std::shared_ptr<const TargetList> targets_;
  std::vector<Index> vertex_of_element_;  // printed: the vertex of each kept point
  std::vector<Index> nearest_;            // printed: the vertex of the reconstruction nearest to each target
};

}  // namespace geodrome
