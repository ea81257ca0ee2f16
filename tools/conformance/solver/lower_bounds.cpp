// SPDX-License-Identifier: MIT
// The extension LowerBounds: what a solver says that the true distance is at least.
#include <algorithm>

#include "geodrome/lower_bounds.hpp"
#include "tools/conformance/solver/solver_trial.hpp"
#include "tools/shapes/fuzz_mesh.hpp"

namespace geodrome::conformance {
namespace {

const LowerBounds& table_of(const SolverTrial& t) {
  const auto* table = t.plugin.extension<LowerBounds>();
  if (!table) throw NotApplicable{"the solver does not state lower bounds"};
  return *table;
}

std::vector<double> bounds_of(const SolverTrial& t, const SurfaceMesh& mesh, const ShortestPathMap& map) {
  std::vector<double> bounds(mesh.vertex_count());
  table_of(t).of_vertices(map, bounds);
  return bounds;
}

/// One interval around a true distance.
template <class... Where>
void judge_interval(SolverTrial& t, double bound, double value, double truth, double scale, const Where&... where) {
  const double slack = rounding * scale;
  t.at_least(bound, 0, "the bound ", where...);
  t.at_most(bound, truth + slack, "the bound ", where...);
  t.at_most(bound, value + slack, "the bound beside the distance, ", where...);
  if (!std::isfinite(value) || !std::isfinite(truth)) return;
  t.at_most(std::abs(value - truth), value - bound + slack, "the error beside the width, ", where...);
  if (t.has_factor()) t.at_most(value, t.plugin.factor * bound + slack, "the distance beside the bound, ", where...);
}

/// Two sources at vertices, one of them with a start distance if the solver takes that.
std::vector<Source> two_sources(const SolverTrial& t, const SurfaceMesh& mesh) {
  const auto last = static_cast<Index>(mesh.face_count() - 1);
  std::vector<Source> sources{{mesh.at_vertex(mesh.triangles()[0][0])}, {mesh.at_vertex(mesh.triangles()[last][1])}};
  if (t.has(Provides::start_distances)) sources[1].start = 0.3;
  return sources;
}

void at_vertices(SolverTrial& t) {
  table_of(t);
  const SolverPlugin exact = t.reference();
  std::vector<MeshPtr> meshes{terrain(14, 2, 91), bumpy_torus(24, 12, 0.1, 93)};
  for (const std::uint64_t seed : {1, 7, 24, 115})
    meshes.push_back(std::make_shared<const SurfaceMesh>(shapes::fuzz_mesh(seed).mesh));
  for (const MeshPtr& mesh : meshes) {
    if (!t.fits(*mesh) || mesh->face_count() == 0 || mesh->face_count() > 1500) continue;
    Running judged(t.plugin, mesh), truth(exact, mesh);
    const std::vector<Source> sources = two_sources(t, *mesh);
    const auto wanted = truth.run(sources).vertices();
    const ShortestPathMap& map = judged.run(sources);
    const std::vector<double> bounds = bounds_of(t, *mesh, map);
    for (Index v = 0; v < mesh->vertex_count(); ++v)
      judge_interval(t, bounds[v], map.vertices()[v], wanted[v], largest_finite(wanted), mesh->face_count(),
                     " faces, vertex ", v);
  }
}

void at_points(SolverTrial& t) {
  const LowerBounds& table = table_of(t);
  const MeshPtr mesh = terrain(12, 1.5, 95);
  t.needs_fit(mesh);
  Running judged(t.plugin, mesh), truth(t.reference(), mesh);
  const std::vector<Source> sources = two_sources(t, *mesh);
  const ShortestPathMap &map = judged.map(sources), &wanted = truth.map(sources);
  const std::vector<double> bounds = bounds_of(t, *mesh, map);
  for (Index v = 0; v < mesh->vertex_count(); ++v) t.equal(table.at(map, mesh->at_vertex(v)), bounds[v], "vertex ", v);
  if (!t.has(Provides::any_point) || (t.has_factor() && !t.has(Provides::factor_any_point))) return;
  std::mt19937_64 random(97);
  for (int i = 0; i < 200; ++i) {
    const SurfacePoint at = random_point(*mesh, random);
    judge_interval(t, table.at(map, at), map.at(at).value, wanted.at(at).value, 20, "face ", at.face);
  }
}

/// What was not reached because of a limit has a finite bound, what has no path an infinite one.
void judge_limited(SolverTrial& t, const SurfaceMesh& mesh, const ShortestPathMap& map,
                   std::span<const double> wanted) {
  const std::vector<double> bounds = bounds_of(t, mesh, map);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    judge_interval(t, bounds[v], map.vertices()[v], wanted[v], largest_finite(wanted), "vertex ", v);
    t.equal(bounds[v] == infinity, wanted[v] == infinity, "an infinite bound, vertex ", v);
  }
}

void limits(SolverTrial& t) {
  table_of(t);
  const MeshPtr one = terrain(11, 1.5, 61);
  const MeshPtr mesh = both(one, mapped(one, [](const Vec3& p) { return p + Vec3{0, 0, 90}; }));
  t.needs_fit(mesh);
  Running judged(t.plugin, mesh), truth(t.reference(), mesh);
  const std::vector<Source> sources{{mesh->at_vertex(60)}};
  const std::vector<double> wanted = copy(truth.run(sources).vertices());
  judge_limited(t, *mesh, judged.run(sources), wanted);
  if (t.has(Provides::radius_limit))
    for (const double radius : {0.0, 1.0, 4.0})
      judge_limited(t, *mesh, judged.run(sources, {.radius = radius}), wanted);
  if (!t.has(Provides::target_limit)) return;
  const SurfacePoint near = mesh->at_vertex(62);
  judge_limited(t, *mesh, judged.run(sources, {.targets = {&near, 1}, .stop_at_targets = true}), wanted);
}

}  // namespace

DemandTable lower_bound_demands() {
  return {
      solver_demand<at_vertices>("bounds.vertices",
                                 "lower bounds are no longer than true distances, and within factor"),
      solver_demand<at_points>("bounds.points", "so they are at points in faces, and the same at vertices"),
      solver_demand<limits>("bounds.limits", "beyond a limit they are finite and no longer, without a path infinite"),
  };
}

}  // namespace geodrome::conformance
