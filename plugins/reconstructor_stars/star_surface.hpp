// SPDX-License-Identifier: MIT
#pragma once

#include "plugins/common/surfaces/finished_surface.hpp"

namespace geodrome {

/// The paper's surface as printed (Section 2.3): the union of the planar stars of the kept points, where that is a
/// 2-manifold. It is where all stars agree; the paper takes that for granted, and samples of other shapes than spheres
/// and planes seldom do. What is wrong is refused with the places, never repaired.
///
/// A triangle whose centre is farther than 2.5 psi from a point (Lemma 8 gives 2.056) is not in the star of that point,
/// so that holes stay open. Closed components are oriented outwards, open ones as the normal at
/// the lowest point of their lowest face.
///
/// Measures `inconsistent_stars` and `star_ties`.
class StarSurface final : public SurfaceReconstructor {
 public:
  struct Settings {
    BoundaryRule boundary;
  };
  static constexpr auto options = settings_table(boundary_option(
      &Settings::boundary,
      "auto: holes with 20 points around or more stay open, smaller ones are an error; closed: any hole "
      "is an error; open: every hole stays open"));

  explicit StarSurface(const OptionValues& values) : settings_(options.parsed(values)) {}

  /// Throws SampleError, with the worst places as findings, if there are fewer than three points or no triangles, the
  /// union is no oriented 2-manifold, it has a boundary that the option forbids, or over 5 % of the points are on no
  /// face. O(n log n).
  Reconstruction reconstruct(const PointSample& sample, const Tangents& tangents, const Control& control,
                             std::span<const Index> kept, RunContext& context) const override;

 private:
  Settings settings_;
};

}  // namespace geodrome
