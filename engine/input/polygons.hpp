// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "engine/formats/soup.hpp"
#include "engine/input/origin.hpp"
#include "geodrome/surface.hpp"

namespace geodrome::input {

/// The faces that stay after cleaning: three or more different corners each, as entries of the used positions.
struct Polygons {
  std::vector<Index> corners;
  std::vector<std::size_t> end;     ///< per polygon: one past its last corner
  std::vector<Index> face_in_file;  ///< per polygon
  Finding degenerate, repeated;     ///< what was dropped, what was shortened

  std::size_t size() const noexcept { return end.size(); }
  std::span<const Index> operator[](std::size_t p) const {
    const std::size_t begin = p == 0 ? 0 : end[p - 1];
    return std::span(corners).subspan(begin, end[p] - begin);
  }
};

/// Drops faces without area for want of three different corners, and joins corners of a polygon that follow each other
/// and are the same vertex. `element_of_row` as in Input.
Polygons clean_faces(const Soup& soup, std::span<const Index> element_of_row);

struct Triangulated {
  std::vector<Triangle> triangles;
  std::vector<Index> face_of_triangle;  ///< face in the file
  std::size_t polygons_split = 0;
  Finding nonplanar;
};

/// Splits polygons into triangles: a fan from the first corner that sees the whole polygon; where none does, and where
/// the polygon has holes with bridges to them (edges passed twice, in opposite directions), ears are clipped in its
/// mean plane, whatever corner it begins with. Corners never move. Rejects (unsupported), naming the face, a polygon
/// that crosses or touches itself, and one that no corner sees and that leaves its mean plane by more than a hundredth
/// of its extent. Polygons that leave it by more than 1e-5 are told. O(sum of squared corners) for usual polygons.
Triangulated triangulate(const Origin& origin, const Polygons& polygons, std::span<const Vec3> positions);

}  // namespace geodrome::input
