// SPDX-License-Identifier: MIT
#include "plugins/common/surfaces/manifold_faces.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "geodrome/vertex_components.hpp"

namespace geodrome {
namespace {

/// Names the fan of every corner (3 f + i) by its lowest corner.
std::vector<Index> fans_of_corners(std::span<const Triangle> faces, std::span<const Index> twins) {
  const auto vertex = [&](Index corner) { return faces[corner / 3][corner % 3]; };
  detail::DisjointSets fans(twins.size());
  for (Index h = 0; h < twins.size(); ++h) {
    const Index twin = twins[h];
    if (twin == no_index || twin < h) continue;
    for (const Index here : {h, SurfaceMesh::next(h)})
      for (const Index there : {twin, SurfaceMesh::next(twin)})
        if (vertex(here) == vertex(there)) fans.unite(here, there);
  }
  std::vector<Index> fan(twins.size());
  for (Index corner = 0; corner < fan.size(); ++corner) fan[corner] = fans.find(corner);
  return fan;
}

}  // namespace

std::size_t drop_minor_fans(std::vector<Triangle>& faces, std::size_t vertex_count) {
  const std::size_t before = faces.size();
  for (;;) {
    const detail::Connectivity connectivity = detail::connect(faces, vertex_count);
    if (connectivity.manifold || connectivity.twins.empty()) return before - faces.size();
    const std::vector<Index> fan = fans_of_corners(faces, connectivity.twins);
    std::vector<std::size_t> size(fan.size(), 0);
    for (const Index f : fan) ++size[f];
    std::vector<Index> best(vertex_count, no_index);
    for (Index corner = 0; corner < fan.size(); ++corner) {
      Index& kept = best[faces[corner / 3][corner % 3]];
      if (kept == no_index || size[fan[corner]] > size[kept]) kept = fan[corner];
    }
    std::vector<Triangle> left;
    for (Index f = 0; f < faces.size(); ++f) {
      bool keep = true;
      for (Index i = 0; i < 3; ++i) keep = keep && best[faces[f][i]] == fan[3 * f + i];
      if (keep) left.push_back(faces[f]);
    }
    faces = std::move(left);
  }
}

std::vector<Index> split_vertices(std::span<const Triangle> faces, std::span<const Index> twins,
                                  std::size_t vertex_count) {
  const std::vector<Index> fan = fans_of_corners(faces, twins);
  std::vector<Index> first(vertex_count, no_index);
  std::vector<bool> split(vertex_count, false);
  for (Index corner = 0; corner < fan.size(); ++corner) {
    const Index v = faces[corner / 3][corner % 3];
    if (first[v] == no_index) first[v] = fan[corner];
    if (first[v] != fan[corner]) split[v] = true;
  }
  std::vector<Index> result;
  for (Index v = 0; v < vertex_count; ++v)
    if (split[v]) result.push_back(v);
  return result;
}

std::vector<Index> orient_alike(std::vector<Triangle>& faces, std::span<const Index> twins) {
  const auto from = [&](Index h) { return faces[h / 3][h % 3]; };
  enum : char { unseen, as_is, turned };
  std::vector<char> side(faces.size(), unseen);
  std::vector<Index> waiting, impossible;
  for (Index seed = 0; seed < faces.size(); ++seed) {
    if (side[seed] != unseen) continue;
    side[seed] = as_is;
    waiting.push_back(seed);
    while (!waiting.empty()) {
      const Index f = waiting.back();
      waiting.pop_back();
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        if (twins[h] == no_index) continue;
        const Index g = twins[h] / 3;
        const bool alike = from(h) != from(twins[h]);
        const char wanted = alike == (side[f] == as_is) ? as_is : turned;
        if (side[g] == unseen) side[g] = wanted, waiting.push_back(g);
        if (side[g] != wanted) impossible.push_back(h);
      }
    }
  }
  for (Index f = 0; f < faces.size(); ++f)
    if (side[f] == turned) std::swap(faces[f][1], faces[f][2]);
  std::sort(impossible.begin(), impossible.end());
  return impossible;
}

void orient_outwards(std::vector<Triangle>& faces, std::span<const Vec3> points) {
  const detail::Connectivity connectivity = detail::connect(faces, points.size());
  const std::vector<Index> component_of = vertex_components(faces, points.size());
  std::vector<double> volume(points.size(), 0);
  std::vector<bool> open(points.size(), false);
  for (Index f = 0; f < faces.size(); ++f) {
    const Index component = component_of[faces[f][0]];
    const auto& [a, b, c] = faces[f];
    const Vec3 origin = points[component];
    volume[component] += dot(points[a] - origin, cross(points[b] - origin, points[c] - origin));
    for (Index i = 0; i < 3; ++i)
      if (connectivity.twins[3 * f + i] == no_index) open[component] = true;
  }
  for (Triangle& t : faces) {
    const Index component = component_of[t[0]];
    if (!open[component] && volume[component] < 0) std::swap(t[1], t[2]);
  }
}

BoundaryFacts boundary_facts(const SurfaceMesh& mesh) {
  constexpr std::size_t shown = 10;
  BoundaryFacts facts;
  detail::DisjointSets loops(mesh.vertex_count());
  std::set<Index> on_boundary;
  for (Index h = 0; h < mesh.twins().size(); ++h) {
    if (mesh.twins()[h] != no_index) continue;
    loops.unite(mesh.from(h), mesh.to(h));
    on_boundary.insert({mesh.from(h), mesh.to(h)});
  }
  for (const Index v : on_boundary) {
    if (loops.find(v) == v) ++facts.loops;
    if (facts.some_vertices.size() < shown) facts.some_vertices.push_back(v);
  }
  const std::vector<Index> component = vertex_components(mesh);
  for (Index v = 0; v < component.size(); ++v)
    if (component[v] == v) ++facts.components;
  return facts;
}

}  // namespace geodrome
