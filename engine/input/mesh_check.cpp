// SPDX-License-Identifier: MIT
#include "engine/input/mesh_check.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/formats/remedies.hpp"
#include "engine/input/coincident_edges.hpp"
#include "engine/input/findings.hpp"
#include "engine/input/float32_steps.hpp"
#include "engine/input/merge.hpp"

namespace geodrome::input {
namespace {

using Severity = Finding::Severity;

// Area at most this times the longest edge squared: no angle of such a triangle means anything.
constexpr double zero_area = 1e-14;

bool has_zero_area(const Vec3& p, const Vec3& q, const Vec3& r) {
  Vec3 a = q - p, b = r - p;
  const double extent =
      std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z), std::abs(b.x), std::abs(b.y), std::abs(b.z)});
  if (extent == 0) return true;
  a = a / extent, b = b / extent;  // squares of very small or large edges would leave the range of double
  const double longest = std::max({squared_norm(a), squared_norm(b), squared_distance(a, b)});
  return 0.5 * norm(cross(a, b)) <= zero_area * longest;
}

Finding find_zero_areas(const Input& input) {
  Finding found;
  for (std::size_t t = 0; t < input.triangles.size(); ++t) {
    const auto& [a, b, c] = input.triangles[t];
    if (has_zero_area(input.positions[a], input.positions[b], input.positions[c]))
      add_element(found, input.face_of_triangle[t]);
  }
  return found;
}

// Polygons with the same vertices, in whatever order, next to each other; of each group all but the first are
// duplicates.
Finding find_duplicate_faces(const Polygons& polygons) {
  Polygons sorted{polygons.corners, polygons.end};
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    const std::size_t size = polygons[p].size();
    const auto end = sorted.corners.begin() + static_cast<std::ptrdiff_t>(polygons.end[p]);
    std::sort(end - static_cast<std::ptrdiff_t>(size), end);
  }
  std::vector<Index> order(polygons.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto less = [&](Index p, Index q) { return std::ranges::lexicographical_compare(sorted[p], sorted[q]); };
  std::stable_sort(order.begin(), order.end(), less);
  std::vector<Index> duplicates;
  for (std::size_t i = 1; i < order.size(); ++i)
    if (std::ranges::equal(sorted[order[i - 1]], sorted[order[i]]))
      duplicates.push_back(polygons.face_in_file[order[i]]);
  std::sort(duplicates.begin(), duplicates.end());
  Finding found;
  for (const Index face : duplicates) add_element(found, face);
  return found;
}

Finding find_duplicate_positions(const Input& input) {
  Finding found;
  const MergedPoints merged = merge_equal_points(input.positions);
  Index places = 0;
  for (Index v = 0; v < input.positions.size(); ++v) {
    if (merged.element_of_row[v] == places)
      ++places;
    else
      add_element(found, v);
  }
  return found;
}

Finding find_isolated(const Input& input) {
  std::vector<bool> used(input.positions.size());
  for (const Triangle& triangle : input.triangles)
    for (const Index v : triangle) used[v] = true;
  Finding found;
  for (Index v = 0; v < used.size(); ++v)
    if (!used[v]) add_element(found, v);
  return found;
}

void tell_defects(const Polygons& polygons, Input& input) {
  InputFacts& facts = input.facts;
  Finding zero = find_zero_areas(input), duplicates = find_duplicate_faces(polygons);
  Finding places = find_duplicate_positions(input), isolated = find_isolated(input);
  facts.zero_area_faces = zero.count;
  facts.duplicate_faces = duplicates.count;
  facts.duplicate_positions = places.count;
  facts.isolated_vertices = isolated.count;
  places.remedy = remedies::weld();
  report(input.findings, std::move(zero), Severity::warning, "zero_area_faces",
         counted(facts.zero_area_faces, "triangle has", "triangles have") + " no area; angles there mean nothing.");
  report(
      input.findings, std::move(duplicates), Severity::warning, "duplicate_faces",
      counted(facts.duplicate_faces, "face names", "faces name") + " the same vertices as an earlier face; they stay.");
  report(input.findings, std::move(places), Severity::warning, "duplicate_positions",
         counted(facts.duplicate_positions, "vertex is", "vertices are") +
             " at the same place as an earlier one; no path leads from one to the other there.");
  report(input.findings, std::move(isolated), Severity::warning, "isolated_vertices",
         counted(facts.isolated_vertices, "vertex is", "vertices are") + " on no face: unreachable.");
}

void tell_orientation(Topology& topology, Input& input) {
  InputFacts& facts = input.facts;
  facts.orientable = topology.orientable;
  facts.oriented = topology.clashes.count == 0 && facts.nonmanifold_edges == 0;
  const std::size_t clashes = topology.clashes.count;
  const std::string what =
      counted(clashes, "edge lies", "edges lie") + " between faces that run the same way along it: ";
  if (topology.orientable)
    report(input.findings, std::move(topology.clashes), Severity::warning, "not_oriented",
           what + "the surface is orientable, but not oriented.");
  else
    report(input.findings, std::move(topology.clashes), Severity::warning, "not_orientable",
           what + "the surface is not orientable.");
}

void tell_topology(Topology topology, Input& input) {
  InputFacts& facts = input.facts;
  facts.nonmanifold_edges = topology.nonmanifold_edges.count;
  facts.nonmanifold_vertices = topology.nonmanifold_vertices.count;
  facts.manifold = facts.nonmanifold_edges == 0 && facts.nonmanifold_vertices == 0;
  facts.components = topology.components;
  facts.boundary_edges = topology.boundary_edges.count;
  facts.boundary_loops = topology.boundary_loops;
  report(input.findings, std::move(topology.nonmanifold_edges), Severity::warning, "nonmanifold_edges",
         counted(facts.nonmanifold_edges, "edge has", "edges have") +
             " more than two faces (the vertices named are on them).");
  report(input.findings, std::move(topology.nonmanifold_vertices), Severity::warning, "nonmanifold_vertices",
         counted(facts.nonmanifold_vertices, "vertex joins", "vertices join") +
             " several fans of faces that share no edge there.");
  tell_orientation(topology, input);
  tell_coincident_edges(topology.open_edges, input);
  report(input.findings, std::move(topology.boundary_edges), Severity::note, "boundary",
         counted(facts.boundary_edges, "boundary edge", "boundary edges") + " in " +
             counted(facts.boundary_loops, "loop", "loops") + " (the vertices named are on them).");
  const long euler = static_cast<long>(topology.vertices) - static_cast<long>(topology.edges) +
                     static_cast<long>(input.triangles.size());
  facts.euler_number = euler;
  // Sum over the components of 2 - 2 g - b.
  if (facts.manifold && facts.orientable)
    facts.genus = (2 * static_cast<long>(facts.components) - static_cast<long>(facts.boundary_loops) - euler) / 2;
  if (facts.components > 1)
    input.findings.push_back(
        {Severity::note,
         "components",
         counted(facts.components, "component", "components") + ": no path leads from one to another.",
         facts.components,
         {}});
}

}  // namespace

void check_mesh(const Polygons& polygons, Input& input) {
  tell_defects(polygons, input);
  tell_topology(topology_of(input.triangles, input.positions.size()), input);
  tell_float32_steps(input);
}

}  // namespace geodrome::input
