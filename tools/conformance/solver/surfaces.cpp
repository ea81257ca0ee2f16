// SPDX-License-Identifier: MIT
// Kinds of surfaces: components, boundaries, degenerate and non-manifold faces, input that is hardly a surface.
#include <algorithm>

#include "geodrome/engine/audit.hpp"
#include "tools/conformance/solver/solver_trial.hpp"

namespace geodrome::conformance {
namespace {

void components(SolverTrial& t) {
  const MeshPtr mesh = both(octahedron(), mapped(octahedron(), [](const Vec3& p) { return p + Vec3{5, 0, 0}; }));
  t.needs_fit(mesh);
  Running running(t.plugin, mesh);
  const ShortestPathMap& map = running.run({{mesh->at_vertex(0)}});
  for (Index v = 0; v < 6; ++v) t.holds(std::isfinite(map.vertices()[v]), "finite", "vertex ", v);
  for (Index v = 6; v < 12; ++v) {
    const Distance distance = map.at(mesh->at_vertex(v));
    t.equal(map.vertices()[v], infinity, "vertex ", v);
    t.equal(distance.value, infinity, "vertex ", v);
    t.holds(distance.reach == Reach::unreachable, "Reach::unreachable", "vertex ", v);
    t.holds(distance.source == no_index, "no source", "vertex ", v);
  }
}

void a_source_in_each_component(SolverTrial& t) {
  const MeshPtr mesh = both(octahedron(), mapped(octahedron(), [](const Vec3& p) { return p + Vec3{5, 0, 0}; }));
  t.needs_fit(mesh);
  Running running(t.plugin, mesh);
  const ShortestPathMap& map = running.run({{mesh->at_vertex(8)}, {mesh->at_vertex(2)}});
  for (Index v = 0; v < 12; ++v) {
    const Vec3 p = mesh->positions()[v], q = mesh->positions()[v < 6 ? 2 : 8];
    const double apart = geodrome::distance(p, q), truth = apart > 1.9 ? 2 * std::sqrt(1.5) : apart;
    t.distance(map.vertices()[v], truth, 3, "vertex ", v);
    t.equal(map.at(mesh->at_vertex(v)).source, v < 6 ? 1u : 0u, "source of vertex ", v);
  }
}

void vertices_on_no_face(SolverTrial& t) {
  const MeshPtr whole = octahedron();
  std::vector<Vec3> positions{{9, 9, 9}};
  positions.insert(positions.end(), whole->positions().begin(), whole->positions().end());
  positions.push_back({0, 0, 0});
  std::vector<Triangle> triangles;
  for (const Triangle& f : whole->triangles()) triangles.push_back({f[0] + 1, f[1] + 1, f[2] + 1});
  const MeshPtr mesh = make(positions, triangles);
  t.needs_fit(mesh);
  Running running(t.plugin, mesh);
  const auto values = running.run({{mesh->at_vertex(1)}}).vertices();
  t.equal(values[0], infinity, "vertex 0");
  t.equal(values[7], infinity, "vertex 7");
  t.distance(values[2], 2 * std::sqrt(1.5), 3, "opposite corner");
}

void face_without_area(SolverTrial& t) {
  const MeshPtr mesh =
      make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}}, {{0, 1, 3}, {1, 2, 3}, {0, 2, 1}, {0, 4, 2}});
  t.needs_fit(mesh);
  Running running(t.plugin, mesh);
  for (Index v = 0; v < 5; ++v) {
    const auto from = running.run({{mesh->at_vertex(v)}}).vertices();
    for (Index w = 0; w < 5; ++w)
      t.distance(from[w], geodrome::distance(mesh->positions()[v], mesh->positions()[w]), 2, "from ", v, " to ", w);
  }
}

/// Every third interior edge of a grid gets its midpoint as a vertex on one side only.
void many_faces_without_area(SolverTrial& t) {
  const MeshPtr grid = plane_grid(6);
  std::vector<Vec3> positions(grid->positions().begin(), grid->positions().end());
  std::vector<Triangle> triangles;
  for (Index f = 0; f < grid->face_count(); ++f) {
    const auto [a, b, c] = grid->triangles()[f];
    if (f % 3 || grid->twins()[3 * f] == no_index) {
      triangles.push_back({a, b, c});
      continue;
    }
    const auto middle = static_cast<Index>(positions.size());
    positions.push_back((positions[a] + positions[b]) / 2);
    triangles.push_back({a, middle, c}), triangles.push_back({middle, b, c}), triangles.push_back({a, b, middle});
  }
  const MeshPtr mesh = make(positions, triangles);
  t.needs_fit(mesh);
  Running running(t.plugin, mesh);
  for (Index v = 0; v < mesh->vertex_count(); v += 7) {
    const auto from = running.run({{mesh->at_vertex(v)}}).vertices();
    for (Index w = 0; w < mesh->vertex_count(); ++w)
      t.distance(from[w], geodrome::distance(positions[v], positions[w]), 9, "from ", v, " to ", w);
  }
}

void far_from_the_origin(SolverTrial& t) {
  const MeshPtr mesh = mapped(octahedron(), [](const Vec3& p) { return p + Vec3{1e8, 1e8, 0}; });
  t.needs_fit(mesh);
  Running running(t.plugin, mesh);
  const auto values = running.run({{mesh->at_vertex(0)}}).vertices();
  t.distance(values[1], 2 * std::sqrt(1.5), 3, "opposite corner");
  t.distance(values[2], std::sqrt(2), 3, "neighbour");
}

void through_a_bow_tie(SolverTrial& t) {
  const MeshPtr mesh = bow_tie();
  t.needs_fit(mesh);
  Running running(t.plugin, mesh);
  t.distance(running.run({{mesh->at_vertex(1)}}).vertices()[3], 2 * std::sqrt(2), 3, "the other wing");
}

/// The three leaves unfold to pairs of triangles that share the edge of length 1.
void over_an_edge_of_three_faces(SolverTrial& t) {
  const MeshPtr mesh = book();
  t.needs_fit(mesh);
  Running running(t.plugin, mesh);
  const auto values = running.run({{mesh->at_vertex(2)}}).vertices();
  t.distance(values[3], std::sqrt(2) + 1, 3, "second leaf");
  t.distance(values[4], std::sqrt(2) + 1, 3, "third leaf");
}

void moebius_strip(SolverTrial& t) {
  const MeshPtr mesh = moebius(24);
  t.needs_fit(mesh);
  Running running(t.plugin, mesh);
  for (const double value : running.run({{mesh->at_vertex(0)}}).vertices())
    t.holds(std::isfinite(value), "finite", "a vertex of the strip");
}

/// One triangle; the same triangle twice, back to back; a strip folded onto itself; vertices that share their places.
void hardly_a_surface(SolverTrial& t) {
  const std::vector<Vec3> corners{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
  const MeshPtr meshes[] = {make(corners, {{0, 1, 2}}), make(corners, {{0, 1, 2}, {2, 1, 0}}),
                            make({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {3, 0, 0}}, {{0, 1, 2}, {0, 2, 3}})};
  for (const MeshPtr& mesh : meshes) {
    if (!t.fits(*mesh)) continue;
    Running running(t.plugin, mesh);
    const auto values = running.run({{mesh->at_vertex(1)}}).vertices();
    t.distance(values[0], 3, 5, "over one edge");
    t.distance(values[2], 5, 5, "over the other");
  }
  if (t.checks() == 0) throw NotApplicable{"the solver states that it needs another kind of mesh"};
}

/// No faces; all vertices at one place; all on a line. An error of Geodrome is an answer, a wrong number is none.
void no_surface(SolverTrial& t) {
  const auto may_refuse = [&](const MeshPtr& mesh, auto&& judge_it) {
    if (!t.fits(*mesh)) return;
    try {
      Running running(t.plugin, mesh);
      judge_it(running);
    } catch (const Error&) {
      t.holds(true, "refused");
    }
  };
  may_refuse(make({{0, 0, 0}, {1, 0, 0}}, {}), [&](Running&) { t.holds(true, "prepared"); });
  const MeshPtr point = make({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}});
  may_refuse(point, [&](Running& running) {
    for (const double value : running.run({{point->at_vertex(0)}}).vertices()) t.equal(value, 0.0, "all at one place");
  });
  const MeshPtr line = make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1, 2}, {1, 3, 2}});
  may_refuse(line, [&](Running& running) {
    const auto values = running.run({{line->at_vertex(0)}}).vertices();
    for (Index v = 0; v < 4; ++v) t.distance(values[v], v, 3, "on a line, vertex ", v);
  });
  if (t.checks() == 0) throw NotApplicable{"the solver states that it needs another kind of mesh"};
}

void audit_of(SolverTrial& t, const MeshPtr& mesh, const std::vector<Source>& sources, const char* name) {
  if (!t.fits(*mesh)) return;
  Running running(t.plugin, mesh);
  const AuditResult result = audit(*mesh, sources, running.map(sources), t.plugin.info.provides,
                                   {.factor = t.plugin.factor, .points_per_edge = 3});
  t.holds(result.paths > 0, "some paths are traced", name);
  if (t.has(Provides::any_point) && t.has_factor())
    t.at_most(result.worst_lipschitz, rounding, name, ", jump on a face: ", result.where);
  t.at_most(result.worst_path, rounding, name, ", length of a path against its distance: ", result.where);
}

/// Exact symmetry: straight lines run through flat vertices, where wavefronts meet.
void audit_of_flat_surfaces(SolverTrial& t) {
  t.needs(Provides::any_point | Provides::paths);
  const std::pair<const char*, MeshPtr> meshes[] = {
      {"plane", plane_grid(8)}, {"crossed plane", plane_grid(8, true)}, {"cube", cube()}, {"prism", prism(12, 8, 0.2)}};
  for (const auto& [name, mesh] : meshes) {
    audit_of(t, mesh, {{mesh->at_vertex(0)}}, name);
    audit_of(t, mesh, {{mesh->at_vertex(static_cast<Index>(mesh->vertex_count() / 2))}}, name);
  }
}

void audit_of_rough_surfaces(SolverTrial& t) {
  t.needs(Provides::any_point | Provides::paths);
  const MeshPtr torus = bumpy_torus(18, 10, 0.08, 31);
  audit_of(t, torus, {{torus->at_vertex(11)}}, "bumpy torus");
  const MeshPtr stretched = mapped(terrain(9, 1, 53), [](const Vec3& p) { return Vec3{p.x, 300 * p.y, p.z}; });
  audit_of(t, stretched, {{stretched->at_vertex(44)}}, "terrain of needles");
}

/// Paths cross several faces without area at one place, one after the other. A solver that cannot trace such a path may
/// say so; a path of another length is no answer.
void audit_of_seams(SolverTrial& t) {
  t.needs(Provides::any_point | Provides::paths);
  for (const Index count : {1, 2, 5, 10}) {
    const MeshPtr mesh = seam(count, count);
    t.needs_fit(mesh);
    for (const Index source : {Index{0}, count / 2 + 1, count + 2, count + 3}) try {
        audit_of(t, mesh, {{mesh->at_vertex(source)}}, "seam");
      } catch (const NumericalError& refusal) {
        throw NotApplicable{text("the solver refuses such paths: ", refusal.what())};
      }
  }
}

void audit_with_many_sources(SolverTrial& t) {
  t.needs(Provides::any_point | Provides::paths | Provides::face_sources);
  const MeshPtr mesh = terrain(12, 3, 37);
  t.needs_fit(mesh);
  std::mt19937_64 random(41);
  std::vector<Source> sources;
  for (int i = 0; i < 5; ++i) sources.push_back({random_point(*mesh, random)});
  audit_of(t, mesh, sources, "terrain");
  if (!t.has(Provides::start_distances)) return;
  for (Source& source : sources) source.start = 3 * uniform(random);
  audit_of(t, mesh, sources, "terrain, with start distances");
}

}  // namespace

DemandTable surface_demands() {
  return {
      solver_demand<components>("surfaces.components", "what no source is connected with is at infinity, unreachable"),
      solver_demand<a_source_in_each_component>("surfaces.a_source_each",
                                                "sources in several components serve each its own"),
      solver_demand<vertices_on_no_face>("surfaces.loose_vertices", "vertices on no face are at infinity"),
      solver_demand<face_without_area>("surfaces.no_area", "a face without area is crossed like any other"),
      solver_demand<many_faces_without_area>("surfaces.many_without_area", "so are many"),
      solver_demand<far_from_the_origin>("surfaces.far_away",
                                         "1e8 sizes from the origin distances are those of the coordinates"),
      solver_demand<through_a_bow_tie>("surfaces.bow_tie", "fans that meet at a vertex alone are connected there"),
      solver_demand<over_an_edge_of_three_faces>("surfaces.three_faces", "an edge with three faces leads to each"),
      solver_demand<moebius_strip>("surfaces.moebius", "a strip that cannot be oriented is solved"),
      solver_demand<hardly_a_surface>("surfaces.few_faces",
                                      "one face, two faces back to back, faces folded on each other"),
      solver_demand<no_surface>("surfaces.none", "no faces, no extent, no area at all: right or refused"),
      solver_demand<audit_of_flat_surfaces>("surfaces.audit_flat",
                                            "no jump on a face, no path of another length: flat surfaces"),
      solver_demand<audit_of_rough_surfaces>("surfaces.audit_rough", "the same on rough surfaces and needles"),
      solver_demand<audit_of_seams>("surfaces.audit_no_area", "the same through faces without area, many in a row"),
      solver_demand<audit_with_many_sources>("surfaces.audit_sources", "the same with many sources in faces"),
  };
}

}  // namespace geodrome::conformance
