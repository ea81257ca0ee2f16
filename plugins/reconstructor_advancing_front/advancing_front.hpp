// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/common/surfaces/finished_surface.hpp"

namespace geodrome {

/// CGAL's advancing front surface reconstruction (Cohen-Steiner and Da, A greedy Delaunay-based surface reconstruction
/// algorithm, 2004) over the 3D Delaunay triangulation; a sample in a plane is triangulated there.
///
/// A triangle is no face of the surface if an edge is longer than 4.96 min psi of its ends (Lemma 9, corrected), or,
/// unless boundary=closed, its circumradius exceeds 2.5 min psi of its corners. So clusters far apart become components
/// and holes stay open. The normals of the tangent planes are not used. Closed components are oriented outwards.
class AdvancingFront final : public SurfaceReconstructor {
 public:
  struct Settings {
    BoundaryRule boundary;
  };
  static constexpr auto options = settings_table(boundary_option(
      &Settings::boundary, "auto: a boundary is allowed and reported; closed: it is an error; open: it is expected"));

  explicit AdvancingFront(const OptionValues& values) : settings_(options.parsed(values)) {}

  /// Throws SampleError if there are fewer than three points, all on a line, no faces, an edge of three faces, no
  /// orientation, a boundary under boundary=closed, or over 5 % of the points are left out. O(n log n) typically.
  Reconstruction reconstruct(const PointSample& sample, const Tangents& tangents, const Control& control,
                             std::span<const Index> kept, RunContext& context) const override;

 private:
  Settings settings_;
};

}  // namespace geodrome
