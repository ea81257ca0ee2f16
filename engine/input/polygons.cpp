// SPDX-License-Identifier: MIT
#include "engine/input/polygons.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/input/ear_clipping.hpp"
#include "engine/input/findings.hpp"

namespace geodrome::input {
namespace {

// How far, relative to its extent, a corner may leave the mean plane of a polygon called planar: the rounding of
// coordinates written with six digits. Only a warning hangs on it.
constexpr double planar_tolerance = 1e-5;
// The part of its extent by which a polygon that is split in its mean plane may leave it: beyond, that plane says
// nothing of the surface that is meant.
constexpr double nearly_planar_tolerance = 1e-2;
// A fan's triangle that is turned over by less than this, relative to the extent squared, is flat by rounding.
constexpr double turned_tolerance = 1e-12;

void join_repeated(std::vector<Index>& corners) {
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
}

bool all_different(std::vector<Index> corners) {
  std::sort(corners.begin(), corners.end());
  return std::adjacent_find(corners.begin(), corners.end()) == corners.end();
}

// A polygon seen from its mean plane: corners relative to the first and scaled to extent 1, and the unit normal.
struct Flat {
  std::vector<Vec3> corners;
  Vec3 normal;  ///< 0 if the polygon has no area
};

Flat flatten(std::span<const Index> polygon, std::span<const Vec3> positions) {
  Flat flat;
  double extent = 0;
  for (const Index corner : polygon) {
    const Vec3 d = flat.corners.emplace_back(positions[corner] - positions[polygon[0]]);
    extent = std::max({extent, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  }
  if (extent == 0) return flat;
  for (Vec3& corner : flat.corners) corner = corner / extent;
  // Newell: the sum of the areas of a fan does not depend on its apex.
  for (std::size_t i = 2; i < flat.corners.size(); ++i)
    flat.normal = flat.normal + cross(flat.corners[i - 1], flat.corners[i]);
  const double area = norm(flat.normal);
  flat.normal = area > turned_tolerance ? flat.normal / area : Vec3{};
  return flat;
}

double thickness(const Flat& flat) {
  double low = 0, high = 0;
  for (const Vec3& corner : flat.corners) {
    const double height = dot(flat.normal, corner);
    low = std::min(low, height), high = std::max(high, height);
  }
  return high - low;
}

// The least of the signed doubled areas of the triangles of a fan; negative if one is turned over.
double least_area(const Flat& flat, std::size_t apex) {
  const std::size_t n = flat.corners.size();
  double least = INFINITY;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Vec3 a = flat.corners[(apex + i) % n] - flat.corners[apex],
               b = flat.corners[(apex + i + 1) % n] - flat.corners[apex];
    least = std::min(least, dot(flat.normal, cross(a, b)));
  }
  return least;
}

// A fan may turn all its triangles one way and still go round its apex more than once: then it meets its first edge
// again.
bool goes_round(const Flat& flat, std::size_t apex) {
  const std::size_t n = flat.corners.size();
  const double tolerance = static_cast<double>(n) * turned_tolerance;  // turns by rounding add up
  const auto side = [&](const Vec3& a, const Vec3& b) { return dot(flat.normal, cross(a, b)); };
  const auto from_apex = [&](std::size_t i) { return flat.corners[(apex + i) % n] - flat.corners[apex]; };
  const Vec3 first = from_apex(1);
  for (std::size_t i = 2; i + 1 < n; ++i)
    if (side(from_apex(i), first) > tolerance && side(first, from_apex(i + 1)) >= 0) return true;
  return false;
}

// The first corner whose fan has no flat triangle; else the first whose fan has none that is turned over; none if no
// corner sees the whole polygon.
std::optional<std::size_t> choose_apex(const Flat& flat) {
  std::optional<std::size_t> fallback;
  for (std::size_t apex = 0; apex < flat.corners.size(); ++apex) {
    const double least = least_area(flat, apex);
    if (least < -turned_tolerance || goes_round(flat, apex)) continue;
    if (least > turned_tolerance) return apex;
    if (!fallback) fallback = apex;
  }
  return fallback;
}

// All corners on a line, within rounding.
bool is_line(const Flat& flat) {
  const auto farthest = std::ranges::max_element(flat.corners, {}, [](const Vec3& c) { return squared_norm(c); });
  return std::ranges::all_of(flat.corners,
                             [&](const Vec3& c) { return norm(cross(*farthest, c)) <= turned_tolerance; });
}

// The corners in the polygon's plane, counterclockwise around its normal.
std::vector<PlanePoint> in_plane(const Flat& flat) {
  const auto farthest = std::ranges::max_element(flat.corners, {}, [](const Vec3& c) { return squared_norm(c); });
  const Vec3 along = *farthest - dot(flat.normal, *farthest) * flat.normal;
  const Vec3 u = along / norm(along), v = cross(flat.normal, u);
  std::vector<PlanePoint> points;
  for (const Vec3& corner : flat.corners) points.push_back({dot(u, corner), dot(v, corner)});
  return points;
}

// The corners seen along the axis closest to the normal, counterclockwise: no rounding but that of the grid.
std::vector<GridPoint> on_grid(std::span<const Index> polygon, std::span<const Vec3> positions, const Vec3& normal) {
  const auto [x, y, z] = normal;
  const double axis[] = {std::abs(x), std::abs(y), std::abs(z)};
  const auto dropped = static_cast<std::size_t>(std::ranges::max_element(axis) - axis);
  const auto coordinate = [](const Vec3& p, std::size_t i) { return i == 0 ? p.x : i == 1 ? p.y : p.z; };
  const bool turned = coordinate(normal, dropped) < 0;
  const std::size_t first = (dropped + (turned ? 2 : 1)) % 3, second = (dropped + (turned ? 1 : 2)) % 3;
  double extent = 0;
  for (const Index corner : polygon)
    for (const std::size_t i : {first, second})
      extent = std::max(extent, std::abs(coordinate(positions[corner] - positions[polygon[0]], i)));
  const int shift = std::ilogb(grid_extent) - 1 - std::ilogb(extent);
  std::vector<GridPoint> grid;
  for (const Index corner : polygon) {
    const Vec3 d = positions[corner] - positions[polygon[0]];
    grid.push_back({std::llround(std::ldexp(coordinate(d, first), shift)),
                    std::llround(std::ldexp(coordinate(d, second), shift))});
  }
  return grid;
}

// The same corners, begun where the list is smallest: so the triangles do not depend on where the file begins it.
std::vector<Index> begun_anywhere(std::span<const Index> polygon) {
  std::vector<Index> corners(polygon.begin(), polygon.end()), best = corners;
  const Index least = *std::ranges::min_element(corners);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    if (corners[0] == least && corners < best) best = corners;
  }
  return best;
}

class Triangulator {
 public:
  Triangulator(const Origin& origin, std::span<const Vec3> positions) : origin_(origin), positions_(positions) {}

  void add(std::span<const Index> polygon, Index face) {
    if (polygon.size() == 3) return add_fan(polygon, face, 0);
    ++result_.polygons_split;
    const bool simple = all_different({polygon.begin(), polygon.end()});
    const Flat flat = flatten(polygon, positions_);
    const bool has_area = flat.normal != Vec3{} || (simple && is_line(flat));
    const auto apex = simple && has_area ? choose_apex(flat) : std::nullopt;
    if (apex && thickness(flat) > planar_tolerance) add_element(result_.nonplanar, face);
    apex ? add_fan(polygon, face, *apex) : add_ears(begun_anywhere(polygon), face);
  }
  Triangulated result() { return std::move(result_); }

 private:
  [[noreturn]] void reject(Index face, const std::string& what) const {
    origin_.reject(InputFault::unsupported, origin_.face(face) + " is a polygon that " + what,
                   "split the faces into triangles");
  }

  void add_fan(std::span<const Index> polygon, Index face, std::size_t apex) {
    const std::size_t n = polygon.size();
    for (std::size_t i = 1; i + 1 < n; ++i)
      add_triangle({polygon[apex], polygon[(apex + i) % n], polygon[(apex + i + 1) % n]}, face);
  }

  void add_ears(const std::vector<Index>& polygon, Index face) {
    const Flat flat = flatten(polygon, positions_);
    constexpr const char* crossing = "crosses itself, touches itself, or comes back to a corner by no bridge to a hole";
    if (flat.normal == Vec3{}) reject(face, crossing);
    const double height = thickness(flat);
    if (height > nearly_planar_tolerance)
      reject(face, "no corner sees all of, and that is not planar: it leaves its mean plane by " +
                       std::to_string(std::lround(100 * height)) + " % of its extent");
    const std::vector<GridPoint> walk = on_grid(polygon, positions_, flat.normal);
    if (!bounds_one_region(walk)) reject(face, crossing);
    const auto ears = clip_ears(walk, in_plane(flat));
    if (!ears) reject(face, crossing);
    if (height > planar_tolerance) add_element(result_.nonplanar, face);
    for (const auto& [a, b, c] : *ears)
      if (all_different({polygon[a], polygon[b], polygon[c]})) add_triangle({polygon[a], polygon[b], polygon[c]}, face);
  }

  void add_triangle(const Triangle& triangle, Index face) {
    result_.triangles.push_back(triangle);
    result_.face_of_triangle.push_back(face);
  }

  const Origin& origin_;
  const std::span<const Vec3> positions_;
  Triangulated result_;
};

}  // namespace

Polygons clean_faces(const Soup& soup, std::span<const Index> element_of_row) {
  Polygons polygons;
  for (Index f = 0; f < soup.face_count(); ++f) {
    std::vector<Index> corners;
    for (const Index row : soup.face(f)) corners.push_back(element_of_row[row]);
    const std::size_t given = corners.size();
    join_repeated(corners);
    if (corners.size() < 3) {
      add_element(polygons.degenerate, f);
      continue;
    }
    if (corners.size() < given) add_element(polygons.repeated, f);
    polygons.corners.insert(polygons.corners.end(), corners.begin(), corners.end());
    polygons.end.push_back(polygons.corners.size());
    polygons.face_in_file.push_back(f);
  }
  return polygons;
}

Triangulated triangulate(const Origin& origin, const Polygons& polygons, std::span<const Vec3> positions) {
  Triangulator triangulator(origin, positions);
  for (std::size_t p = 0; p < polygons.size(); ++p) triangulator.add(polygons[p], polygons.face_in_file[p]);
  Triangulated result = triangulator.result();
  if (result.triangles.size() >= no_index / 3)
    origin.reject(InputFault::unsupported, "more triangles than 32 bits count");
  return result;
}

}  // namespace geodrome::input
