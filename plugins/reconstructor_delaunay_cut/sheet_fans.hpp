// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "geodrome/surface.hpp"

namespace geodrome {

/// Triangles of a sheet, added one by one, that never fold over: seen along the normal of any point, the triangles
/// around it lie side by side. So an edge has at most two, and an open sheet needs no inside to be told from outside.
class SheetFans {
 public:
  /// `points` and their unit `normals`, of arbitrary sign, must outlive this object.
  SheetFans(std::span<const Vec3> points, std::span<const Vec3> normals);

  /// Tells whether the triangle lies beside all that are there, at each of its corners, and no edge of it crosses an
  /// edge of these. O(triangles around the corners and their neighbours).
  bool fits(const Triangle& triangle) const;

  /// Precondition: it fits.
  void add(const Triangle& triangle);

  const std::vector<Triangle>& faces() const noexcept { return faces_; }
  bool uses(Index point) const { return !sectors_[point].empty(); }

  /// How many faces the edge has.
  int faces_at(Index a, Index b) const;

  /// A place at a point where no triangle lies, between two edges of one face each.
  struct Gap {
    Index from, to;
  };
  /// Lists the gaps around a point counter-clockwise: none if it is inside the sheet, several if fans meet there alone.
  std::vector<Gap> gaps(Index point) const;

 private:
  /// What a triangle covers around a corner: counter-clockwise from one neighbour to another.
  struct Sector {
    Index first, last;
    double begin, width;
  };

  Sector sector(Index at, Index a, Index b) const;
  bool crosses(Index a, Index b) const;

  std::span<const Vec3> points_;
  std::vector<Vec3> u_, v_;  // axes of the tangent planes
  std::vector<std::vector<Sector>> sectors_;
  std::vector<Triangle> faces_;
};

}  // namespace geodrome
