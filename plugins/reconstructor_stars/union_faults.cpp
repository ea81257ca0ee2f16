// SPDX-License-Identifier: MIT
#include "plugins/reconstructor_stars/union_faults.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "geodrome/detail/connectivity.hpp"
#include "plugins/common/surfaces/manifold_faces.hpp"

namespace geodrome {
namespace {

Fault crowded_edges(std::span<const Triangle> faces) {
  Fault fault{"crowded_edges", {}, 0, {}};
  const std::vector<detail::EdgeUse> uses = detail::sorted_edge_uses(faces);
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
    while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
    if (end - i <= 2) continue;
    ++fault.count;
    fault.places.insert(fault.places.end(), {uses[i].low, uses[i].high});
  }
  fault.places = worst_first(std::move(fault.places));
  fault.message = counted(fault.count, "edge has", "edges have") + " more than two faces.";
  return fault;
}

Fault split_points(std::span<const Triangle> faces, std::span<const Index> twins, std::size_t point_count) {
  std::vector<Index> places = split_vertices(faces, twins, point_count);
  const std::size_t count = places.size();
  return {"split_points", "faces meet in several fans at " + counted(count, "point.", "points."), count,
          std::move(places)};
}

Fault two_sided_edges(std::vector<Triangle>& faces, std::span<const Index> twins) {
  const std::vector<Triangle> before = faces;
  const std::vector<Index> impossible = orient_alike(faces, twins);
  std::vector<Index> places;
  for (const Index h : impossible) places.insert(places.end(), {before[h / 3][h % 3], before[h / 3][(h + 1) % 3]});
  const std::size_t edges = impossible.size() / 2;  // each is met from both of its faces
  return {"not_orientable", "the surface cannot be oriented across " + counted(edges, "edge.", "edges."), edges,
          worst_first(std::move(places))};
}

/// Boundary loops of fewer than `least` points. `faces` run alike.
Fault short_loops(std::span<const Triangle> faces, std::size_t point_count, std::size_t least) {
  const std::vector<Index> twins = detail::connect(faces, point_count).twins;
  detail::DisjointSets loops(point_count);
  std::vector<Index> on_boundary;
  for (Index h = 0; h < twins.size(); ++h) {
    if (twins[h] != no_index) continue;
    const Index from = faces[h / 3][h % 3];
    loops.unite(from, faces[h / 3][(h + 1) % 3]);
    on_boundary.push_back(from);  // every boundary point once, since faces run alike
  }
  std::vector<std::size_t> length(point_count, 0);
  for (const Index p : on_boundary) ++length[loops.find(p)];
  Fault fault{"", {}, 0, {}};
  for (const Index p : on_boundary) {
    if (length[loops.find(p)] >= least) continue;
    fault.places.push_back(p);
    fault.count += loops.find(p) == p;
  }
  std::sort(fault.places.begin(), fault.places.end());
  return fault;
}

Fault forbidden_boundary(std::span<const Triangle> faces, std::size_t point_count, BoundaryRule rule) {
  if (rule == BoundaryRule::closed) {
    Fault fault = short_loops(faces, point_count, std::numeric_limits<std::size_t>::max());
    fault.code = "boundary";
    fault.message = "the surface has " + counted(fault.count, "boundary loop.", "boundary loops.");
    return fault;
  }
  Fault fault = short_loops(faces, point_count, rule == BoundaryRule::automatic ? least_around_hole : 0);
  fault.code = "thin_places";
  fault.message = counted(fault.count, "place is", "places are") +
                  " thinner sampled than psi explains, with fewer than 20 points around: no hole, and no faces.";
  return fault;
}

}  // namespace

std::vector<Index> worst_first(std::vector<Index> points) {
  std::sort(points.begin(), points.end());
  std::vector<std::pair<std::ptrdiff_t, Index>> by_count;
  for (auto at = points.begin(); at != points.end();) {
    const auto end = std::upper_bound(at, points.end(), *at);
    by_count.emplace_back(at - end, *at);
    at = end;
  }
  std::sort(by_count.begin(), by_count.end());
  points.clear();
  for (const auto& [count, point] : by_count) points.push_back(point);
  return points;
}

std::optional<Fault> orient_or_fault(std::vector<Triangle>& faces, std::span<const Vec3> points, BoundaryRule rule) {
  if (Fault fault = crowded_edges(faces); fault.count > 0) return fault;
  const std::vector<Index> twins = detail::connect(faces, points.size()).twins;
  if (Fault fault = split_points(faces, twins, points.size()); fault.count > 0) return fault;
  if (Fault fault = two_sided_edges(faces, twins); fault.count > 0) return fault;
  orient_outwards(faces, points);
  if (Fault fault = forbidden_boundary(faces, points.size(), rule); fault.count > 0) return fault;
  return std::nullopt;
}

}  // namespace geodrome
