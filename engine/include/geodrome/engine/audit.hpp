// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "geodrome/shortest_path_solver.hpp"

namespace geodrome {

struct AuditOptions {
  double factor = 1;                ///< the solver's guarantee; +inf: only the paths are audited
  double share = 1;                 ///< of the mesh's faces, in (0, 1]
  std::span<const Index> faces;     ///< that they are chosen from, each once; empty: all
  std::size_t points_per_edge = 2;  ///< sampled on each edge of an audited face, beside its corners
  std::uint64_t seed = 0;
  double scale = 0;  ///< the length that violations are relative to; 0: the largest finite distance audited
};

/// Worst violations found, relative to the scale of the options, or else to `scale`. A value at rounding level (1e-12
/// or so) is none.
struct AuditResult {
  std::size_t faces = 0, pairs = 0, paths = 0;
  double scale = 0;  ///< the largest finite distance audited, in the units of the input
  double worst_lipschitz =
      0;                  ///< max of D(x)/factor - D(y) - w |xy| over pairs in a common face, over scale; at least 0
  double worst_path = 0;  ///< max of |length of path + start - D| over scale, where path_is_distance is provided
  Index worst_lipschitz_face = no_index, worst_path_face = no_index;
  std::string where;  ///< one line for people about the worst place
};

/// The audit: exactness without a second solver. A function that is 1-Lipschitz on every face and equals the start
/// distance at the sources is nowhere longer than the true distance; one whose every value is the length of a path is
/// nowhere shorter. Checks both, at sampled points, through the map alone, and that it is a function: one value at an
/// edge or a vertex, whichever face it is asked on. For a factor f the bound becomes D(x) <= f (D(y) + |xy|). `map`
/// must come from a request with Keep::map whose radius, if any, reaches all points of the faces. On a mesh with
/// weights |xy| and lengths are weighted: by the weight w of the face, along an edge by the smallest of its faces.
/// O(faces x samples x query).
AuditResult audit(const SurfaceMesh& mesh, std::span<const Source> sources, const ShortestPathMap& map,
                  Provides provides, const AuditOptions& options);

}  // namespace geodrome
