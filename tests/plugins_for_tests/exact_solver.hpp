// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/shortest_path_solver.hpp"
#include "tests/support/loaded_solver.hpp"

/// The exact solver that plugins for tests wrap: `solver_chen_han` of the build, loaded from its file, so that a change
/// to its code relinks none of them. Targets get the file by geodrome_load_exact_solver() (tests/CMakeLists.txt).
namespace geodrome::test {

class ExactSolver final : public LoadedSolver {
 public:
  static constexpr Provides provides = Provides::start_distances | Provides::face_sources | Provides::radius_limit |
                                       Provides::target_limit | Provides::any_point | Provides::paths |
                                       Provides::path_is_distance | Provides::factor_any_point |
                                       Provides::never_shorter;

  ExactSolver() : LoadedSolver(GEODROME_EXACT_SOLVER) {}
};

}  // namespace geodrome::test
