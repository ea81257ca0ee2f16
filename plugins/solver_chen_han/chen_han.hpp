// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/settings.hpp"
#include "geodrome/shortest_path_solver.hpp"
#include "plugins/solver_chen_han/settings.hpp"

namespace geodrome {

/// Exact distances by windows: Chen and Han (1990, 1996), with the filters of Xin and Wang (2009) and whole lists
/// carried across triangles (Qin et al. 2016).
///
/// Any mesh: open, non-manifold, unoriented, with faces without area. A search allocates only while it grows; a run
/// costs what it reaches: O(w log F) for w windows, w ~ F^1.5 on smooth surfaces. With Keep::targets only the wavefront
/// is in memory.
class ChenHanSolver final : public ShortestPathSolver {
 public:
  static constexpr Provides provides = Provides::start_distances | Provides::face_sources | Provides::radius_limit |
                                       Provides::target_limit | Provides::any_point | Provides::paths |
                                       Provides::path_is_distance | Provides::factor_any_point |
                                       Provides::never_shorter;
  struct Choices {
    bool filter;
    std::string simd;
    chen_han::Rows rows;
    std::uint32_t lists_memory;
  };
  static constexpr auto options = settings_table(
      option("filter", &Choices::filter, "xin_wang", "xin_wang|off", {true, false},
             "drop windows that a vertex makes needless; off shows what that brings, on small meshes"),
      option("simd", &Choices::simd, "auto", "auto|baseline|avx2|avx512",
             "processor level of the inner loops; same results"),
      option("rows", &Choices::rows, "auto", "auto|plain|lists",
             {chen_han::Rows::automatic, chen_han::Rows::plain, chen_han::Rows::lists},
             "how rows of a matrix are made: each alone, or by lists of direct paths; auto: less work"),
      option("lists_memory", &Choices::lists_memory, "2048", 1, 1048576, "MiB", "lists of direct paths take no more"));

  /// Throws OptionError for a level that the processor does not have.
  explicit ChenHanSolver(const OptionValues& values) : ChenHanSolver(options.parsed(values)) {}

  /// O(F log F). Throws CapabilityError for face weights.
  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext& context) const override;

 private:
  explicit ChenHanSolver(const Choices& choices);

  chen_han::Settings settings_;
};

}  // namespace geodrome
