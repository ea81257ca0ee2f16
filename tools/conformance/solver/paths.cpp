// SPDX-License-Identifier: MIT
// Paths: where they lead, and how long they are.

#include "tools/conformance/solver/path_trial.hpp"

namespace geodrome::conformance {
namespace {

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
