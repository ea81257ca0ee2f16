// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plugins/common/surfaces/finished_surface.hpp"

namespace geodrome {

/// A hole of a sample has at least so many points around it; fewer are a thin place.
inline constexpr std::size_t least_around_hole = 20;

/// One way in which faces are no surface, and where.
struct Fault {
  const char* code;
  std::string message;
  std::size_t count = 0;
  std::vector<Index> places;  ///< points, worst first
};

/// The points, each once, those named most often first (ties: the lowest).
std::vector<Index> worst_first(std::vector<Index> points);

/// What first keeps `faces` from being an oriented 2-manifold with a boundary as the rule allows; nothing is left out
/// or added. Looked for in this order: edges of more than two faces, points where faces meet in several fans, edges
/// across which faces cannot run alike, and boundary loops: under BoundaryRule::closed any, under
/// BoundaryRule::automatic those of fewer than `least_around_hole` points. Where the first three are none, `faces` are
/// turned to run alike, those of closed components outwards. O(F log F).
std::optional<Fault> orient_or_fault(std::vector<Triangle>& faces, std::span<const Vec3> points, BoundaryRule rule);

}  // namespace geodrome
