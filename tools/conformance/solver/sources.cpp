// SPDX-License-Identifier: MIT
// Several sources that crowd, and that start late: the nearest counts.
#include <algorithm>
#include <random>

#include "tools/conformance/solver/solver_trial.hpp"

namespace geodrome::conformance {
namespace {

constexpr double scale = 15;  ///< about the largest distance on the mesh

MeshPtr fitting(const SolverTrial& t, MeshPtr mesh) {
  t.needs_fit(mesh);
  return mesh;
}

/// The distances from several sources are the least of those from each alone, and the source named is one of those.
void judge_nearest(SolverTrial& t, Running& running, const SurfaceMesh& mesh, const std::vector<Source>& sources) {
  std::vector<std::vector<double>> alone;
  for (const Source& source : sources) {
    alone.push_back(copy(running.run({{source.at}}).vertices()));
    for (double& distance : alone.back()) distance += source.start;
  }
  const ShortestPathMap& map = running.run(sources);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    double nearest = infinity;
    for (const auto& values : alone) nearest = std::min(nearest, values[v]);
    const Distance found = map.at(mesh.at_vertex(v));
    t.equal(found.value, map.vertices()[v], "at and vertices agree, vertex ", v);
    t.at_most(found.value, t.plugin.factor * nearest + rounding * scale, "from ", sources.size(), " sources, vertex ",
              v);
    t.at_most(nearest, t.plugin.factor * found.value + rounding * scale, "from one source alone, vertex ", v);
    t.holds(found.source < sources.size(), "one of the sources is named, vertex ", v);
    if (found.source < sources.size())
      t.at_most(alone[found.source][v], t.plugin.factor * found.value + rounding * scale,
                "from the source named, vertex ", v);
  }
}

/// Inside one face, on its edges, at its corners, in a neighbour, and at one place twice.
std::vector<SurfacePoint> close_places(const SurfaceMesh& mesh, Index face, std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(0.05, 0.95);
  const auto inside = [&](Index f) {
    const double a = share(random), b = (1 - a) * share(random);
    return SurfacePoint{f, {a, b, 1 - a - b}};
  };
  const double on_edge = share(random);
  std::vector<SurfacePoint> places{
      inside(face), inside(face), inside(face), {face, {on_edge, 1 - on_edge, 0}}, {face, {0, 1, 0}}};
  if (const Index twin = mesh.twins()[3 * face + 1]; twin != no_index) places.push_back(inside(twin / 3));
  std::shuffle(places.begin(), places.end(), random);
  places.push_back(places.front());
  return places;
}

void in_one_face(SolverTrial& t) {
  t.needs(Provides::face_sources | Provides::any_point | Provides::factor_any_point);
  t.needs_factor();
  std::mt19937_64 random(83);
  for (const MeshPtr& mesh : {fitting(t, plane_grid(1)), fitting(t, terrain(11, 1.5, 61))}) {
    Running running(t.plugin, mesh);
    for (int trial = 0; trial < 30; ++trial) {
      const auto face = static_cast<Index>(random() % mesh->face_count());
      const std::vector<SurfacePoint> places = close_places(*mesh, face, random);
      std::vector<Source> sources;
      for (std::size_t i = 0; i < 2 + trial % 6; ++i) sources.push_back({places[i % places.size()]});
      judge_nearest(t, running, *mesh, sources);
    }
  }
}

void with_starts(SolverTrial& t) {
  t.needs(Provides::start_distances);
  t.needs_factor();
  const MeshPtr mesh = fitting(t, terrain(11, 1.5, 61));
  Running running(t.plugin, mesh);
  std::mt19937_64 random(89);
  std::uniform_real_distribution<double> start(0, 3);
  const bool in_faces = t.has(Provides::face_sources | Provides::any_point | Provides::factor_any_point);
  for (int trial = 0; trial < 20; ++trial) {
    const auto face = static_cast<Index>(random() % mesh->face_count());
    const std::vector<SurfacePoint> places = close_places(*mesh, face, random);
    std::vector<Source> sources{{mesh->at_vertex(static_cast<Index>(random() % mesh->vertex_count()))}};
    for (int i = 1; i < 4; ++i) {
      const auto vertex = static_cast<Index>(random() % mesh->vertex_count());
      sources.push_back({in_faces && trial % 2 == 1 ? places[i] : mesh->at_vertex(vertex), start(random)});
    }
    judge_nearest(t, running, *mesh, sources);
  }
}

}  // namespace

DemandTable source_demands() {
  return {
      solver_demand<in_one_face>("sources.in_one_face",
                                 "sources inside one face, on its edges, at its corners, beside it"),
      solver_demand<with_starts>("sources.with_starts", "sources that start at different distances"),
  };
}

}  // namespace geodrome::conformance
