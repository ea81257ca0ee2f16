// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "geodrome/finding.hpp"
#include "geodrome/surface.hpp"
#include "plugins/common/surfaces/face_bounds.hpp"

namespace geodrome {

/// Which triangles cannot be faces of the surface, by the control function psi at their corners.
struct FaceRule {
  static constexpr double edge_bound = face_edge_bound, radius_bound = face_radius_bound;

  std::span<const Vec3> points;
  std::span<const double> psi;
  bool by_radius = true;

  bool allows(Index a, Index b, Index c) const;
};

/// The frame of the plane that holds all points up to `planar_tolerance` of their extent: two axes, right-handed with a
/// normal whose largest component is positive.
struct PlaneFrame {
  Vec3 origin, x, y;
};

/// Thinner samples have no tetrahedra worth the name. A surface of this thickness with two sheets would need some 1e12
/// points, so that nothing but a sheet is taken for one.
inline constexpr double planar_tolerance = 1e-6;

/// The plane of the points, or nothing. Throws SampleError if they lie on a line. O(n).
std::optional<PlaneFrame> common_plane(std::span<const Vec3> points);

/// True if the points lie on a line, up to `planar_tolerance` of their extent. O(n).
bool on_a_line(std::span<const Vec3> points);

/// The Delaunay triangles in the plane that the rule allows, oriented with the frame; a note says how many it does not.
std::vector<Triangle> planar_surface(const PlaneFrame& frame, const FaceRule& rule, std::vector<Finding>& findings);

}  // namespace geodrome
