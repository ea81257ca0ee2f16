// SPDX-License-Identifier: MIT
// The stated factor, against exact solvers.
#include <algorithm>

#include "geodrome/engine/input.hpp"
#include "tools/conformance/solver/solver_trial.hpp"
#include "tools/shapes/fuzz_mesh.hpp"
#include "tools/shapes/hostile.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::conformance {
namespace {

MeshPtr share(SurfaceMesh mesh) { return std::make_shared<const SurfaceMesh>(std::move(mesh)); }

/// Whether the solver states more than that reachable is finite.
void needs_a_bound(const SolverTrial& t) {
  if (!t.has(Provides::never_shorter)) throw NotApplicable{"the solver states neither factor nor never_shorter"};
}

/// A vertex on some face.
Index some_vertex(const SurfaceMesh& mesh, std::mt19937_64& random) {
  return mesh.triangles()[random() % mesh.face_count()][random() % 3];
}

/// Vertices, and points anywhere if the solver knows them, of one search against the same search of an exact solver.
void compare(SolverTrial& t, Running& judged, Running& truth, const MeshPtr& mesh, const SurfacePoint& from,
             std::mt19937_64& random, const std::string& name) {
  const ShortestPathMap& wanted = truth.map({{from}});
  const ShortestPathMap& values =
      judged.run({{from}}, {.keep = t.has(Provides::any_point) ? Keep::map : Keep::targets});
  const double scale = largest_finite(wanted.vertices());
  for (Index v = 0; v < mesh->vertex_count(); ++v)
    t.distance(values.vertices()[v], wanted.vertices()[v], scale, name, ", vertex ", v);
  if (!t.has(Provides::any_point) || (t.has_factor() && !t.has(Provides::factor_any_point))) return;
  for (int k = 0; k < 60; ++k) {
    const SurfacePoint at = random_point(*mesh, random);
    t.distance(values.at(at).value, wanted.at(at).value, scale, name, ", face ", at.face);
  }
}

void against(SolverTrial& t, const SolverPlugin& exact, const MeshPtr& mesh, int sources, const std::string& name) {
  if (!t.fits(*mesh) || mesh->face_count() == 0) return;
  std::mt19937_64 random(mesh->face_count());
  Running judged(t.plugin, mesh), truth(exact, mesh);
  for (int s = 0; s < sources; ++s) {
    const bool in_face = s % 2 == 1 && t.has(Provides::face_sources);
    const SurfacePoint from = in_face ? random_point(*mesh, random) : mesh->at_vertex(some_vertex(*mesh, random));
    compare(t, judged, truth, mesh, from, random, text(name, " by ", exact.info.name, ", source on face ", from.face));
  }
}

/// An exact solver that is not the reference but fast: for meshes on which others take minutes.
SolverPlugin fast_solver(const SolverTrial& t) {
  for (const SolverPlugin& solver : t.exact_solvers())
    if (solver.info.name != "cgal") return solver;
  throw NotApplicable{"there is no other fast exact solver to compare with"};
}

void shapes_meshes(SolverTrial& t) {
  needs_a_bound(t);
  const std::vector<SolverPlugin> solvers = t.exact_solvers();
  if (solvers.empty()) throw NotApplicable{"there is no exact solver to compare with"};
  const std::pair<const char*, MeshPtr> meshes[] = {{"torus", share(shapes::mesh("jittered-torus", 800, 3))},
                                                    {"bumpy", share(shapes::mesh("bumpy", 1000))},
                                                    {"genus2", share(shapes::mesh("genus2", 1200))},
                                                    {"noisy sphere", share(shapes::mesh("noisy-sphere", 1000, 5))},
                                                    {"cut torus", share(shapes::mesh("cut-torus", 600))},
                                                    {"terrain", terrain(16, 2, 7)},
                                                    {"wild terrain", terrain(12, 20, 11)},
                                                    {"bumpy torus", bumpy_torus(24, 12, 0.08, 5)}};
  for (const auto& [name, mesh] : meshes)
    for (const SolverPlugin& exact : solvers) against(t, exact, mesh, 4, name);
}

void fuzz(SolverTrial& t) {
  needs_a_bound(t);
  const SolverPlugin exact = t.reference();
  for (const std::uint64_t seed : {1, 4, 7, 13, 24, 61, 105, 115, 146, 187, 193, 269}) {
    const shapes::FuzzMesh mesh = shapes::fuzz_mesh(seed);
    if (mesh.mesh.face_count() <= 1500)
      against(t, exact, share(mesh.mesh), 2, text("fuzz ", seed, " (", mesh.recipe, ")"));
  }
}

void hostile(SolverTrial& t) {
  needs_a_bound(t);
  const SolverPlugin exact = fast_solver(t);
  for (const shapes::HostileFamily& family : shapes::hostile_families()) {
    const MeshPtr mesh = share(shapes::hostile(family.name, 0));
    const bool is_large = mesh->face_count() > 2000;
    against(t, exact, mesh, is_large ? 1 : 2, family.name);
  }
}

/// A point of a face at its corner `corner`, so near to it that only the other two coordinates tell the difference.
SurfacePoint beside_corner(Index face, int corner, double size, std::mt19937_64& random) {
  SurfacePoint point{face, {}};
  point.b[(corner + 1) % 3] = size * uniform(random), point.b[(corner + 2) % 3] = size * size * uniform(random);
  point.b[corner] = 1 - point.b[(corner + 1) % 3] - point.b[(corner + 2) % 3];
  return point;
}

/// One point in each face at a vertex.
std::vector<SurfacePoint> around(const SurfaceMesh& mesh, Index vertex, double size, std::mt19937_64& random) {
  std::vector<SurfacePoint> points;
  for (Index h = 0; h < 3 * mesh.face_count(); ++h)
    if (mesh.from(h) == vertex) points.push_back(beside_corner(h / 3, static_cast<int>(h % 3), size, random));
  return points;
}

void close_pairs(SolverTrial& t) {
  t.needs(Provides::face_sources | Provides::any_point | Provides::never_shorter);
  if (t.has_factor()) t.needs(Provides::factor_any_point);
  const MeshPtr mesh = bumpy_torus(16, 8, 0.1, 71);
  t.needs_fit(mesh);
  Running judged(t.plugin, mesh), truth(t.reference(), mesh);
  std::mt19937_64 random(73);
  for (const double size : {1e-2, 1e-4, 1e-6, 1e-8})
    for (Index v = 0; v < mesh->vertex_count(); v += 9) {
      const std::vector<SurfacePoint> points = around(*mesh, v, size, random);
      const ShortestPathMap& wanted = truth.run({{points.front()}}, {.targets = points});
      for (const Keep keep : {Keep::targets, Keep::map}) {
        const ShortestPathMap& values = judged.run({{points.front()}}, {.targets = points, .keep = keep});
        for (const SurfacePoint& to : points)
          t.distance(values.at(to).value, wanted.at(to).value, 3, "vertex ", v, ", ", size, " of an edge away, face ",
                     to.face, keep == Keep::map ? ", the map kept" : ", targets kept");
      }
    }
}

void given(SolverTrial& t) {
  if (t.subject.meshes.empty()) throw NotApplicable{"no mesh was given"};
  needs_a_bound(t);
  const SolverPlugin exact = fast_solver(t);
  for (const std::filesystem::path& file : t.subject.meshes) {
    Input input = read_input(file, {.as = InputKind::mesh});
    const MeshPtr mesh = share(SurfaceMesh(std::move(input.positions), std::move(input.triangles)));
    t.holds(t.fits(*mesh), "a mesh that fits the solver's needs", file.string());
    against(t, exact, mesh, 3, file.filename().string());
  }
}

}  // namespace

DemandTable guarantee_demands() {
  return {
      solver_demand<shapes_meshes>("guarantee.shapes",
                                   "against all exact solvers, the factor holds on generated shapes"),
      solver_demand<fuzz>("guarantee.fuzz",
                          "so it does on random meshes with holes, needles, bow-ties, several components"),
      solver_demand<hostile>("guarantee.hostile", "so it does on meshes built to break solvers"),
      solver_demand<close_pairs>("guarantee.close_pairs",
                                 "so it does between points around a vertex, down to 1e-8 of an edge"),
      solver_demand<given>("guarantee.given", "so it does on the meshes that were given"),
  };
}

}  // namespace geodrome::conformance
