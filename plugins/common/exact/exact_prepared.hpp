// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

#include "plugins/common/exact/propagation_search.hpp"

namespace geodrome {

/// A mesh made ready for searches with a propagation: of a class that is made of the packed mesh and the settings.
/// Immutable.
template <class Propagation, class PreparedSearch = PropagationSearch<Propagation>>
class ExactPrepared final : public PreparedSurface {
 public:
  using Settings = typename Propagation::Settings;

  /// Packs the mesh. O(F log F). Throws CapabilityError for a mesh of 2^30 half-edges or more.
  ExactPrepared(MeshPtr mesh, const Settings& settings)
      : surface_(std::make_shared<const PackedMesh>(std::move(mesh))), settings_(settings) {}

  std::unique_ptr<Search> make_search() const override { return std::make_unique<PreparedSearch>(surface_, settings_); }
  std::size_t bytes() const override { return surface_->bytes(); }
  const std::shared_ptr<const PackedMesh>& surface() const { return surface_; }
  const Settings& settings() const { return settings_; }

 private:
  std::shared_ptr<const PackedMesh> surface_;
  Settings settings_;
};

/// Implements ShortestPathSolver::prepare of an exact solver. Throws CapabilityError for face weights as well.
template <class Propagation, class PreparedSearch = PropagationSearch<Propagation>>
std::unique_ptr<PreparedSurface> prepare_exact(MeshPtr mesh, const typename Propagation::Settings& settings,
                                               RunContext& context) {
  context.throw_if_cancelled();
  require_unweighted(*mesh);
  return std::make_unique<ExactPrepared<Propagation, PreparedSearch>>(std::move(mesh), settings);
}

}  // namespace geodrome
