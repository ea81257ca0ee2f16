// SPDX-License-Identifier: MIT
#include "engine/input/polygons.hpp"

#include <algorithm>
#include <cmath>

#include "engine/input/findings.hpp"

namespace geodrome::input {
namespace {

// How far, relative to its extent, a corner may leave the mean plane of a polygon called planar: the rounding of
// coordinates written with six digits. Only a warning hangs on it.
constexpr double planar_tolerance = 1e-5;
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

bool is_planar(const Flat& flat) {
  double low = 0, high = 0;
  for (const Vec3& corner : flat.corners) {
    const double height = dot(flat.normal, corner);
    low = std::min(low, height), high = std::max(high, height);
  }
  return high - low <= planar_tolerance;
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

// The first corner whose fan has no flat triangle; else the first whose fan has none that is turned over.
std::size_t choose_apex(const Flat& flat) {
  const std::size_t n = flat.corners.size();
  std::size_t fallback = n;
  for (std::size_t apex = 0; apex < n; ++apex) {
    const double least = least_area(flat, apex);
    if (least > turned_tolerance) return apex;
    if (fallback == n && least >= -turned_tolerance) fallback = apex;
  }
  return fallback;
}

}  // namespace

Polygons clean_faces(const Origin& origin, const Soup& soup, std::span<const Index> element_of_row) {
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
    if (!all_different(corners))
      origin.reject(InputFault::unsupported, origin.face(f) + " comes back to one of its corners",
                    "split the face into simple ones");
    if (corners.size() < given) add_element(polygons.repeated, f);
    polygons.corners.insert(polygons.corners.end(), corners.begin(), corners.end());
    polygons.end.push_back(polygons.corners.size());
    polygons.face_in_file.push_back(f);
  }
  return polygons;
}

Triangulated triangulate(const Origin& origin, const Polygons& polygons, std::span<const Vec3> positions) {
  Triangulated result;
  result.triangles.reserve(polygons.size());
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    const std::span<const Index> polygon = polygons[p];
    const std::size_t n = polygon.size();
    const Index face = polygons.face_in_file[p];
    std::size_t apex = 0;
    if (n > 3) {
      const Flat flat = flatten(polygon, positions);
      apex = choose_apex(flat);
      if (apex == n)
        origin.reject(InputFault::unsupported, origin.face(face) + " is a polygon that no corner sees all of",
                      "split the faces into triangles");
      if (!is_planar(flat)) add_element(result.nonplanar, face);
      ++result.polygons_split;
    }
    for (std::size_t i = 1; i + 1 < n; ++i) {
      result.triangles.push_back({polygon[apex], polygon[(apex + i) % n], polygon[(apex + i + 1) % n]});
      result.face_of_triangle.push_back(face);
    }
  }
  if (result.triangles.size() >= no_index / 3)
    origin.reject(InputFault::unsupported, "more triangles than 32 bits count");
  return result;
}

}  // namespace geodrome::input
