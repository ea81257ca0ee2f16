// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/reconstructor_delaunay_cut/sheet_surface.hpp"

namespace geodrome {

/// The pieces of a sample that have a boundary, and the sheets made of them.
class OpenSheets {
 public:
  /// Finds the boundaries that the whole sample shows (`boundary_spacing`). `kept` must outlive this object. O(n log
  /// n).
  OpenSheets(const PointSample& sample, const Control& control, const KeptPoints& kept, RunContext& context);

  /// Tells whether any kept point, or any of `members`, lies on a boundary.
  bool any() const noexcept { return any_; }
  bool shown_by(std::span<const Index> members) const;

  /// The members that lie on a boundary, if most of them are inside the faces, which have closed it; else none.
  std::vector<Index> closed_rim(std::span<const Index> members, std::span<const Triangle> faces) const;

  /// As sheet_surface.
  SheetSurface make(const PlanarStars& stars, std::span<const Index> members, bool close_thin) const {
    return sheet_surface(sample_, stars, members, close_thin);
  }

 private:
  Neighbours all_;
  SheetSample sample_;
  bool any_ = false;
};

/// Tells whether a sheet of so many points has no small holes left, and hardly a point beside it.
bool is_whole(const SheetSurface& sheet, std::size_t points);

/// Orients the faces; throws SampleError with the findings of `result` and one more if the sheet is one-sided.
void orient_sheet(SheetSurface& sheet, const KeptPoints& kept, Reconstruction& result);

}  // namespace geodrome
