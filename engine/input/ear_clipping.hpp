// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace geodrome::input {

/// A corner of a polygon seen along an axis, on a grid so fine that rounding to it is that of coordinates, and so
/// coarse that the side on which a corner lies of two others is computed exactly. Lengths and angles are not those of
/// the polygon, but what is straight, convex, inside or crossed stays so.
struct GridPoint {
  std::int64_t x = 0, y = 0;
  friend constexpr bool operator==(const GridPoint&, const GridPoint&) = default;
  friend constexpr auto operator<=>(const GridPoint&, const GridPoint&) = default;
};

/// Coordinates from -grid_extent to grid_extent; their products with one another fit into 128 bits.
inline constexpr double grid_extent = 0x1p51;

/// A corner in the plane of its polygon, with its lengths and angles; the extent of the polygon is about 1.
struct PlanePoint {
  double x = 0, y = 0;
};

/// Twice the signed area of a triangle, exactly: positive if its corners run counterclockwise.
__extension__ using WideInteger = __int128;
constexpr WideInteger doubled_area(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return static_cast<WideInteger>(b.x - a.x) * (c.y - a.y) - static_cast<WideInteger>(b.y - a.y) * (c.x - a.x);
}

/// Whether a walk, interior to the left, bounds one region: its edges cross and touch nowhere but at common ends, and
/// are passed once, or, as bridges to holes, twice in opposite directions; without bridges it is one outline, which
/// turns left, and holes, which turn right. Exact. Edges without length do not matter. O(n^2) at worst, for usual
/// polygons O(n log n).
bool bounds_one_region(std::span<const GridPoint> walk);

/// Triangles of such a walk, as places in it, counterclockwise, of which none has area 0 but for edges without length;
/// none if there are no such triangles. The best-shaped ear is clipped first; of ears that are equally good (within
/// rounding) the first. `plane`: the same corners. O(n^2) for usual polygons. Source: G. H. Meisters, Polygons have
/// ears.
std::optional<std::vector<std::array<std::size_t, 3>>> clip_ears(std::span<const GridPoint> walk,
                                                                 std::span<const PlanePoint> plane);

}  // namespace geodrome::input
