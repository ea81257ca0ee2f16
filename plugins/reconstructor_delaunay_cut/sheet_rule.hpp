// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "plugins/common/points/neighbours.hpp"
#include "plugins/common/surfaces/finished_surface.hpp"

namespace geodrome {

/// What a sheet is made from: the kept points, where these lie on a boundary, and the sample before decimation. All of
/// it outlives those who hold a reference.
struct SheetSample {
  const KeptPoints& kept;
  std::vector<double> spacing;  ///< per kept point: as `boundary_spacing` gives it
  const Neighbours& all;        ///< all points of the sample that were not dropped
};

/// Which triangles may be faces of a sheet, apart from what lies beside them.
class SheetRule {
 public:
  explicit SheetRule(const SheetSample& sample);

  /// The corners in an order that depends on their places alone, so that all that follows does.
  Triangle in_order(const Triangle& triangle) const;
  bool before(const Triangle& a, const Triangle& b) const;

  /// Circumradius; not finite for corners on a line. `triangle` is in order.
  double radius(const Triangle& triangle) const;

  /// Tells whether the triangle runs along the tangent planes of its corners, as the cocone wants it (Amenta, Choi,
  /// Dey and Leekha 2002): one that joins two sheets, or two turns of a roll, runs across them.
  bool lies_flat(const Triangle& triangle) const;

  /// Tells whether psi explains the triangle, and the sample shows no slit and no hole there: a ball around its
  /// circumcentre that is empty, with over 1.8 spacings, between two points of a boundary and a third, farther from
  /// both than 4 spacings.
  bool allows(const Triangle& triangle) const;

 private:
  double spacing_at(const Triangle& triangle) const;
  bool explained_by_psi(const Triangle& triangle) const;
  bool spans_a_hole(const Triangle& triangle) const;

  const SheetSample& sample_;
  std::vector<Index> rank_;
};

}  // namespace geodrome
