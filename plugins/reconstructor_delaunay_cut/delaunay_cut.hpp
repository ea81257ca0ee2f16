// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "geodrome/options.hpp"
#include "plugins/common/surfaces/finished_surface.hpp"

namespace geodrome {

/// The border of a minimal cut: every tetrahedron of the Delaunay triangulation of the kept points is labelled inside
/// or outside, by the tangent planes and by the planar stars (the paper's union of stars, Section 2.3, wherever the
/// stars agree), so that the surface is closed by construction; then repaired to a 2-manifold, and opened where the
/// sample shows a hole. Pieces of the sample that no planar cell connects become components.
///
/// Pieces of which the sample shows a rim, a slit or a hole have no inside: they become sheets, laid from the stars
/// alone (`sheet_surface`), unless boundary=closed.
///
/// A surface that fails a check is refused, never returned: the measures `inconsistent_stars`, `star_ties`, `flips`,
/// `lids`, `rounds` and `epsilon` say how good the sample was.
class DelaunayCut final : public SurfaceReconstructor {
 public:
  struct Settings {
    BoundaryRule boundary;
    bool allow_stars;
  };
  static constexpr auto options = settings_table(
      boundary_option(
          &Settings::boundary,
          "auto: holes that the sample shows stay open, thin places are closed; closed: a hole is an error; "
          "open: every face that psi does not explain is left out"),
      option("stars", &Settings::allow_stars, "refuse", "refuse|allow", {false, true},
             "what becomes of a sample whose planar stars disagree too often"));

  explicit DelaunayCut(const OptionValues& values) : settings_(options.parsed(values)) {}

  /// Throws SampleError, with the density that would do where it can be said, if there are fewer than three points or
  /// all on a line; over 20 % of the star triangles are inconsistent (unless stars=allow); the border is no 2-manifold
  /// after repairs of up to 2 % of the points; over 5 % of the points are left out; a sheet is one-sided; or a hole
  /// is found under boundary=closed. O(n log n) typically.
  Reconstruction reconstruct(const PointSample& sample, const Tangents& tangents, const Control& control,
                             std::span<const Index> kept, RunContext& context) const override;

 private:
  Settings settings_;
};

}  // namespace geodrome
