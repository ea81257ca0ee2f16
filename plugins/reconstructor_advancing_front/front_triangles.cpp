// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/reconstructor_advancing_front/front_triangles.hpp"

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "plugins/common_gpl/guarded.hpp"

namespace geodrome {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// CGAL's own priority for what the rule allows.
struct RulePriority {
  const FaceRule* rule;

  template <class Front, class Cell>
  double operator()(const Front& front, Cell& cell, const int& index) const {
    std::array<std::size_t, 3> corner;
    for (int i = 0; i < 3; ++i) corner[i] = cell->vertex((index + 1 + i) % 4)->info();
    if (*std::max_element(corner.begin(), corner.end()) >= rule->points.size()) return front.infinity();
    if (!rule->allows(static_cast<Index>(corner[0]), static_cast<Index>(corner[1]), static_cast<Index>(corner[2])))
      return front.infinity();
    return front.smallest_radius_delaunay_sphere(cell, index);
  }
};

}  // namespace

std::vector<Triangle> front_triangles(const FaceRule& rule) {
  std::vector<Kernel::Point_3> points;
  for (const Vec3& p : rule.points) points.emplace_back(p.x, p.y, p.z);
  return guarded([&] {
    std::vector<std::array<std::size_t, 3>> found;
    CGAL::advancing_front_surface_reconstruction(points.begin(), points.end(), std::back_inserter(found),
                                                 RulePriority{&rule});
    std::vector<Triangle> faces;
    for (const auto& [a, b, c] : found)
      faces.push_back({static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c)});
    return faces;
  });
}

}  // namespace geodrome
