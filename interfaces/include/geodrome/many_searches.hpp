// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>
#include <span>

#include "geodrome/shortest_path_solver.hpp"

namespace geodrome {

/// The searches that a job is going to run: one from each of `sources` alone, start distance 0, up to `radius`.
struct SearchPlan {
  std::span<const SurfacePoint> sources;
  double radius = std::numeric_limits<double>::infinity();  ///< in the units of the mesh
};

/// Extension (README.md, "Extensions") of a solver whose searches of one surface have work in common that can be done
/// once, before all of them.
struct ManySearches {
  static constexpr const char* id = "geodrome.many_searches/1";

  /// Makes the same surface ready for the searches of a plan. `prepared` is of this plugin and outlives the result.
  ///
  /// The result answers every request as `prepared` does, those outside of the plan included, in the same units, with
  /// the same reach and capabilities; distances may differ by rounding, as those of two paths of the same length do.
  /// Its `bytes` count those of `prepared`; other extensions of the plugin take its searches and maps. Returns null
  /// where it would not pay. Whether it pays, and every distance, depends on surface, options and plan alone: not on
  /// the number of threads, on time, or on what memory the machine has.
  ///
  /// May use `context.threads()`; tells by `context.measure` and one line of the log (info) how it chose and what it
  /// holds, before it takes the memory. Throws Cancelled. Thread-safe.
  std::unique_ptr<PreparedSurface> (*prepare)(const PreparedSurface& prepared, const SearchPlan& plan,
                                              RunContext& context);
};

}  // namespace geodrome
