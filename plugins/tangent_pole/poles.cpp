// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/tangent_pole/poles.hpp"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "plugins/common_gpl/guarded.hpp"

namespace geodrome {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>>>;

/// Twice the area of a triangle over its longest edge squared, below which its normal is rounding.
constexpr double flat_triangle = 1e-8;

auto key(const Vec3& p) { return std::tuple(p.x, p.y, p.z); }

/// The best candidate of one point so far, and the sum of directions of edges without end.
struct Candidate {
  double squared_distance = 0;
  Vec3 centre, outward;
  bool unbounded = false;
};

class PoleSearch {
 public:
  explicit PoleSearch(std::span<const Vec3> points) : points_(points), candidates_(points.size()) {}

  /// The circumcentre of a tetrahedron, unless it is flat, is a Voronoi vertex of its four corners.
  void add_cell(std::array<Index, 4> corners) {
    // In an order that the points alone give, so that rounding is the same for any order of points.
    std::sort(corners.begin(), corners.end(), [&](Index a, Index b) { return key(points_[a]) < key(points_[b]); });
    const Vec3& p = points_[corners[0]];
    const Vec3 a = points_[corners[1]] - p, b = points_[corners[2]] - p, c = points_[corners[3]] - p;
    const double six_volumes = dot(a, cross(b, c));
    const double longest = std::max({squared_norm(a), squared_norm(b), squared_norm(c), squared_norm(a - b),
                                     squared_norm(b - c), squared_norm(c - a)});
    if (std::abs(six_volumes) < 6 * flat_volume * longest * std::sqrt(longest)) return;
    const Vec3 centre =
        (squared_norm(a) * cross(b, c) + squared_norm(b) * cross(c, a) + squared_norm(c) * cross(a, b)) /
        (2 * six_volumes);
    for (const Index corner : corners) offer(corner, squared_norm(centre), p + centre);
  }

  /// A facet of the convex hull, counterclockwise from outside, is crossed by a Voronoi edge without end. Its direction
  /// counts at each corner by the facet's angle there, so that it does not matter how a flat part of the hull is cut.
  void add_hull_facet(const std::array<Index, 3>& corners) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = points_[corners[i]];
      const Vec3 a = points_[corners[(i + 1) % 3]] - p, b = points_[corners[(i + 2) % 3]] - p;
      const Vec3 normal = cross(a, b);
      const double length = norm(normal);
      if (!(length > flat_triangle * std::max({squared_norm(a), squared_norm(b), squared_norm(a - b)}))) return;
      Candidate& at = candidates_[corners[i]];
      at.outward = at.outward + std::atan2(length, dot(a, b)) / length * normal;
      at.unbounded = true;
    }
  }

  std::vector<Pole> poles() const {
    std::vector<Pole> poles(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Candidate& found = candidates_[i];
      // Flat cells alone: the sample is planar here, and the hull has facets on both sides.
      if (!(found.squared_distance > 0)) continue;
      const Vec3 way = found.unbounded ? found.outward : found.centre - points_[i];
      const double length = norm(way);
      if (length > 0) poles[i] = {found.unbounded ? Pole::Kind::unbounded : Pole::Kind::vertex, way / length};
    }
    return poles;
  }

 private:
  void offer(Index at, double squared_distance, const Vec3& centre) {
    Candidate& best = candidates_[at];
    if (squared_distance < best.squared_distance ||
        (squared_distance == best.squared_distance && key(centre) >= key(best.centre)))
      return;
    best.squared_distance = squared_distance;
    best.centre = centre;
  }

  std::span<const Vec3> points_;
  std::vector<Candidate> candidates_;
};

}  // namespace

std::vector<Pole> voronoi_poles(std::span<const Vec3> points) {
  std::vector<std::pair<Kernel::Point_3, Index>> sites;
  for (Index i = 0; i < points.size(); ++i)
    sites.emplace_back(Kernel::Point_3(points[i].x, points[i].y, points[i].z), i);
  return guarded([&] {
    const Delaunay delaunay(sites.begin(), sites.end());
    PoleSearch search(points);
    if (delaunay.dimension() < 3) return search.poles();
    for (const auto& cell : delaunay.finite_cell_handles())
      search.add_cell(
          {cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(), cell->vertex(3)->info()});
    for (auto cell = delaunay.all_cells_begin(); cell != delaunay.all_cells_end(); ++cell) {
      if (!delaunay.is_infinite(cell)) continue;
      const int infinite = cell->index(delaunay.infinite_vertex());
      // The three others as CGAL orders them: counterclockwise from the infinite vertex.
      std::array<Index, 3> facet;
      for (int i = 0; i < 3; ++i) facet[i] = cell->vertex(Delaunay::vertex_triple_index(infinite, i))->info();
      search.add_hull_facet(facet);
    }
    return search.poles();
  });
}

}  // namespace geodrome
