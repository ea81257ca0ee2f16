// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/options.hpp"
#include "geodrome/shortest_path_solver.hpp"

namespace geodrome {

/// Computes exact distances by whole wavefronts in persistent trees: Schreiber (2010), after Schreiber and Sharir
/// (2008).
///
/// Takes any mesh: open, non-manifold, unoriented, with faces without area. A search allocates only while it grows; a
/// run costs what it reaches: O(log n) for each event of a wavefront of n generators, measured about one event a face.
class SchreiberSolver final : public ShortestPathSolver {
 public:
  static constexpr Provides provides = Provides::start_distances | Provides::face_sources | Provides::radius_limit |
                                       Provides::target_limit | Provides::any_point | Provides::paths |
                                       Provides::path_is_distance | Provides::factor_any_point |
                                       Provides::never_shorter;

  explicit SchreiberSolver(const OptionValues&) {}

  /// Packs the mesh. O(F log F). Throws CapabilityError for face weights and for 2^30 half-edges or more.
  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext& context) const override;
};

}  // namespace geodrome
