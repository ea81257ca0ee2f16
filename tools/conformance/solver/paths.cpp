// SPDX-License-Identifier: MIT
// Paths: where they lead, and how long they are.
#include <algorithm>

#include "engine/surface/common_face.hpp"
#include "tools/conformance/solver/solver_trial.hpp"

namespace geodrome::conformance {
namespace {

/// One path on `mesh` from `point` to the nearest of the sources at `at`.
void judge_path(SolverTrial& t, const SurfaceMesh& mesh, const CommonFace& common, const ShortestPathMap& map,
                const SurfacePoint& point, const std::vector<SurfacePoint>& at, double scale) {
  std::vector<SurfacePoint> path;
  map.path(point, path);
  const Index source = map.at(point).source;
  const bool on_mesh = std::ranges::all_of(path, [&](const SurfacePoint& p) { return p.face < mesh.face_count(); });
  t.holds(!path.empty() && on_mesh && source < at.size(), "a path on faces of the mesh to one of the sources",
          "from face ", point.face);
  if (path.empty() || !on_mesh || source >= at.size()) return;
  t.holds(path.front() == point, "it begins at the point", "from face ", point.face);
  t.near(common.straight(path.back(), at[source]).value_or(infinity), 0, rounding * scale,
         "distance of its end from the source, from face ", point.face);
  double length = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const auto step = common.straight(path[i], path[i + 1]);
    t.holds(step.has_value(), "a step within a face", "step ", i, " from face ", point.face);
    length += step.value_or(0);
  }
  if (t.has(Provides::path_is_distance))
    t.near(length, map.at(point).value, rounding * scale, "length, from face ", point.face);
  else if (t.approximates())  // the path may be nearer to the true distance
    t.same_distance(length, map.at(point).value, scale, "length, from face ", point.face);
  else
    t.at_least(length, map.at(point).value - rounding * scale, "length, from face ", point.face);
}

void to_sources(SolverTrial& t, Provides bits, int corner_sources) {
  t.needs(bits);
  const MeshPtr mesh = terrain(11, 1.5, 61);
  t.needs_fit(mesh);
  Running running(t.plugin, mesh);
  const CommonFace common(*mesh);
  std::mt19937_64 random(73);
  std::vector<SurfacePoint> at;
  std::vector<Source> sources;
  for (int i = 0; i < 3; ++i) {
    at.push_back(i < corner_sources ? mesh->at_vertex(50 * i + 3) : random_point(*mesh, random));
    sources.push_back({at.back()});
  }
  const ShortestPathMap& map = running.map(sources);
  for (int i = 0; i < 80; ++i) {
    const SurfacePoint point = t.has(Provides::any_point)
                                   ? random_point(*mesh, random)
                                   : mesh->at_vertex(static_cast<Index>(random() % mesh->vertex_count()));
    judge_path(t, *mesh, common, map, point, at, 15);
  }
}

void from_vertices(SolverTrial& t) { to_sources(t, Provides::paths, 3); }
void from_face_sources(SolverTrial& t) { to_sources(t, Provides::paths | Provides::face_sources, 0); }

void none_from_another_component(SolverTrial& t) {
  t.needs(Provides::paths);
  const MeshPtr one = plane_grid(5), mesh = both(one, mapped(one, [](const Vec3&p) { return p + Vec3{0, 0, 50}; }));
  t.needs_fit(mesh);
  Running running(t.plugin, mesh);
  std::vector<SurfacePoint> path{{0, {1, 0, 0}}};
  running.map({{mesh->at_vertex(0)}}).path(mesh->at_vertex(static_cast<Index>(one->vertex_count())), path);
  t.holds(path.empty(), "an empty path");
}

void from_the_source(SolverTrial& t) {
  t.needs(Provides::paths);
  const MeshPtr mesh = terrain(6, 1, 63);
  t.needs_fit(mesh);
  Running running(t.plugin, mesh);
  const CommonFace common(*mesh);
  const SurfacePoint source = mesh->at_vertex(17);
  judge_path(t, *mesh, common, running.map({{source}}), source, {source}, 8);
}

}  // namespace

DemandTable path_demands() {
  return {
      solver_demand<from_vertices>("paths.lead_to_sources",
                                   "paths run on the surface to their source, as long as the distance"),
      solver_demand<from_face_sources>("paths.lead_into_faces", "so they do to sources in faces"),
      solver_demand<from_the_source>("paths.of_the_source", "the path from the source to itself has length 0"),
      solver_demand<none_from_another_component>("paths.unreachable", "there is none from another component"),
  };
}

}  // namespace geodrome::conformance
