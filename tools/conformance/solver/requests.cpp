// SPDX-License-Identifier: MIT
// What may be asked of a search, bit by declared bit.
#include <algorithm>

#include "tools/conformance/solver/solver_trial.hpp"
#include "tools/shapes/fuzz_mesh.hpp"

namespace geodrome::conformance {
namespace {

MeshPtr request_mesh(const SolverTrial& t) {
  const MeshPtr mesh = terrain(11, 1.5, 61);
  t.needs_fit(mesh);
  return mesh;
}

constexpr double scale = 15;  ///< about the largest distance on that mesh

std::vector<SurfacePoint> some_points(const SurfaceMesh& mesh, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<SurfacePoint> points;
  for (int i = 0; i < count; ++i) points.push_back(random_point(mesh, random));
  return points;
}

void source_vertex(SolverTrial& t) {
  const MeshPtr mesh = request_mesh(t);
  Running running(t.plugin, mesh);
  const Distance distance = running.run({{mesh->at_vertex(30)}}).at(mesh->at_vertex(30));
  t.equal(distance.value, 0.0);
  t.holds(distance.reach == Reach::reached, "Reach::reached");
  t.equal(distance.source, 0u);
}

void source_anywhere(SolverTrial& t) {
  t.needs(Provides::face_sources | Provides::any_point);
  const MeshPtr mesh = request_mesh(t);
  Running running(t.plugin, mesh);
  for (const SurfacePoint& point : some_points(*mesh, 30, 67))
    t.near(running.map({{point}}).at(point).value, 0, rounding * scale, "a source on face ", point.face);
}

/// A point on an edge has a name in each face of the edge, a vertex one in each of its faces: all mean the same point.
void names_of_a_source(SolverTrial& t) {
  t.needs(Provides::face_sources);
  const MeshPtr mesh = request_mesh(t);
  Running running(t.plugin, mesh);
  for (Index h = 0; h < mesh->twins().size(); h += 23) {
    const Index twin = mesh->twins()[h];
    if (twin == no_index) continue;
    for (const double at : {0.0, 0.2, 0.5}) {
      SurfacePoint here{h / 3, {}}, there{twin / 3, {}};
      here.b[h % 3] = 1 - at, here.b[(h + 1) % 3] = at;
      there.b[(twin + 1) % 3] = 1 - at, there.b[twin % 3] = at;
      const auto values = copy(running.run({{here}}).vertices());
      const auto other = running.run({{there}}).vertices();
      for (std::size_t v = 0; v < values.size(); ++v)
        t.near(values[v], other[v], rounding * scale, "a source on half-edge ", h, ", vertex ", v);
    }
  }
}

void many_sources(SolverTrial& t) {
  const MeshPtr mesh = request_mesh(t);
  Running running(t.plugin, mesh);
  const std::vector<Source> sources{{mesh->at_vertex(3)}, {mesh->at_vertex(77)}, {mesh->at_vertex(140)}};
  std::vector<std::vector<double>> alone;
  for (const Source& source : sources) alone.push_back(copy(running.run({source}).vertices()));
  const ShortestPathMap& map = running.run(sources);
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    const double nearest = std::min({alone[0][v], alone[1][v], alone[2][v]});
    t.distance(map.vertices()[v], nearest, scale, "vertex ", v);
    const Index source = map.at(mesh->at_vertex(v)).source;
    t.holds(source < 3, "one of the sources is named", "vertex ", v);
    if (source < 3 && t.has_factor())
      t.at_most(alone[source][v], t.plugin.factor * nearest + rounding * scale, "from the source named, vertex ", v);
  }
}

void first_of_two(SolverTrial& t) {
  const MeshPtr mesh = request_mesh(t);
  Running running(t.plugin, mesh);
  const ShortestPathMap& map = running.run({{mesh->at_vertex(50)}, {mesh->at_vertex(50)}});
  for (Index v = 0; v < mesh->vertex_count(); ++v) t.equal(map.at(mesh->at_vertex(v)).source, 0u, "vertex ", v);
}

void start_distance(SolverTrial& t) {
  t.needs(Provides::start_distances);
  const MeshPtr mesh = request_mesh(t);
  Running running(t.plugin, mesh);
  const auto plain = copy(running.run({{mesh->at_vertex(20)}}).vertices());
  const auto late = copy(running.run({{mesh->at_vertex(20), 2.5}}).vertices());
  for (std::size_t v = 0; v < plain.size(); ++v) t.same_distance(late[v], plain[v] + 2.5, scale, "vertex ", v);
  const ShortestPathMap& map = running.run({{mesh->at_vertex(20)}, {mesh->at_vertex(21), 100}});
  t.same_distance(map.vertices()[21], plain[21], scale, "a late source, reached from an earlier one");
  t.equal(map.at(mesh->at_vertex(21)).source, 0u, "its source");
}

void radius(SolverTrial& t) {
  t.needs(Provides::radius_limit);
  const MeshPtr mesh = request_mesh(t);
  Running running(t.plugin, mesh);
  const auto all = copy(running.run({{mesh->at_vertex(60)}}).vertices());
  const ShortestPathMap& map = running.run({{mesh->at_vertex(60)}}, {.radius = 4});
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    const Distance distance = map.at(mesh->at_vertex(v));
    t.equal(distance.value, map.vertices()[v], "at and vertices agree, vertex ", v);
    t.equal(map.vertices()[v], all[v] <= 4 ? all[v] : infinity, "vertex ", v);
    t.holds(distance.reach == (all[v] <= 4 ? Reach::reached : Reach::beyond_limit), "reached or beyond_limit",
            "vertex ", v);
  }
}

/// Behind lines that are not shortest paths, what is near lies between what is far: a solver that judges many lines by
/// the outermost of them loses it.
void radius_on_hard_meshes(SolverTrial& t) {
  t.needs(Provides::radius_limit);
  if (t.approximates()) t.needs_factor();
  struct Case {
    std::uint64_t seed;
    Index source;
    double radius;
  };
  for (const auto& [seed, source, radius] :
       {Case{42, 265, 11.206482}, Case{262, 343, 6.567359}, Case{344, 120, 296.108496}, Case{884, 6, 115.09322}}) {
    const MeshPtr mesh = std::make_shared<const SurfaceMesh>(shapes::fuzz_mesh(seed).mesh);
    if (!t.fits(*mesh)) continue;
    Running running(t.plugin, mesh);
    const auto all = copy(running.run({{mesh->at_vertex(source)}}).vertices());
    const double share = rounding * largest_finite(all), factor = t.factor_or_one();
    const auto found = running.run({{mesh->at_vertex(source)}}, {.radius = radius}).vertices();
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      if (all[v] > factor * radius + share) t.equal(found[v], infinity, "fuzz ", seed, ", vertex ", v);
      if (factor * all[v] < radius - share)
        t.same_distance(found[v], all[v], largest_finite(all), "fuzz ", seed, ", vertex ", v);
    }
  }
}

void radius_and_components(SolverTrial& t) {
  t.needs(Provides::radius_limit);
  const MeshPtr mesh = both(plane_grid(4), mapped(plane_grid(4), [](const Vec3& p) { return p + Vec3{0, 0, 9}; }));
  t.needs_fit(mesh);
  Running running(t.plugin, mesh);
  const ShortestPathMap& map = running.run({{mesh->at_vertex(0)}}, {.radius = 2});
  const std::size_t half = mesh->vertex_count() / 2;
  t.holds(map.at(mesh->at_vertex(24)).reach == Reach::beyond_limit, "beyond_limit", "the far corner");
  for (Index v = static_cast<Index>(half); v < 2 * half; ++v)
    t.holds(map.at(mesh->at_vertex(v)).reach == Reach::unreachable, "unreachable, not beyond_limit", "vertex ", v);
}

void targets_are_kept(SolverTrial& t) {
  t.needs(Provides::any_point);
  const MeshPtr mesh = request_mesh(t);
  Running running(t.plugin, mesh);
  const std::vector<SurfacePoint> targets = some_points(*mesh, 40, 71);
  std::vector<double> wanted;
  const ShortestPathMap& full = running.map({{mesh->at_vertex(9)}});
  for (const SurfacePoint& target : targets) wanted.push_back(full.at(target).value);
  const ShortestPathMap& map = running.run({{mesh->at_vertex(9)}}, {.targets = targets});
  for (std::size_t i = 0; i < targets.size(); ++i)
    t.near(map.at(targets[i]).value, wanted[i], rounding * scale, "target ", i);
}

void what_was_not_kept(SolverTrial& t) {
  t.needs(Provides::any_point | Provides::paths);
  const MeshPtr mesh = request_mesh(t);
  Running running(t.plugin, mesh);
  const SurfacePoint target{0, {0.25, 0.25, 0.5}}, other{0, {0.5, 0.25, 0.25}};
  const ShortestPathMap& map = running.run({{mesh->at_vertex(9)}}, {.targets = {&target, 1}});
  std::vector<SurfacePoint> path;
  t.holds(std::isfinite(map.at(target).value), "finite", "the target");
  t.throws<CapabilityError>([&] { map.at(other); }, "another point");
  t.throws<CapabilityError>([&] { map.path(target, path); }, "the target's path");
}

void what_is_not_provided(SolverTrial& t) {
  if (t.has(Provides::any_point | Provides::paths)) throw NotApplicable{"the solver provides any_point and paths"};
  const MeshPtr mesh = request_mesh(t);
  Running running(t.plugin, mesh);
  const ShortestPathMap& map = running.map({{mesh->at_vertex(9)}});
  std::vector<SurfacePoint> path;
  if (!t.has(Provides::any_point))
    t.throws<CapabilityError>([&] { map.at({0, {0.25, 0.25, 0.5}}); }, "a point in a face");
  if (!t.has(Provides::paths)) t.throws<CapabilityError>([&] { map.path(mesh->at_vertex(3), path); }, "a path");
}

void point_off_the_mesh(SolverTrial& t) {
  t.needs(Provides::any_point);
  const MeshPtr mesh = request_mesh(t);
  Running running(t.plugin, mesh);
  const ShortestPathMap& map = running.map({{mesh->at_vertex(9)}});
  t.throws<InputError>(
      [&] {
        map.at({static_cast<Index>(mesh->face_count()), {1, 0, 0}});
      },
      "a face that is not there");
  t.throws<InputError>([&] { map.at({0, {-0.5, 1, 0.5}}); }, "a negative coordinate");
  t.throws<InputError>([&] { map.at({0, {infinity, 0, 0}}); }, "an infinite coordinate");
}

void stop_at_targets(SolverTrial& t) {
  t.needs(Provides::target_limit | Provides::any_point);
  const MeshPtr mesh = request_mesh(t);
  Running running(t.plugin, mesh);
  const ShortestPathMap& full = running.map({{mesh->at_vertex(0)}});
  const std::vector<SurfacePoint> targets{mesh->at_vertex(26), {40, {0.2, 0.3, 0.5}}, {45, {0, 0.3, 0.7}}};
  std::vector<double> wanted;
  for (const SurfacePoint& target : targets) wanted.push_back(full.at(target).value);
  const auto all = copy(full.vertices());
  const ShortestPathMap& map = running.run({{mesh->at_vertex(0)}}, {.targets = targets, .stop_at_targets = true});
  for (std::size_t i = 0; i < targets.size(); ++i)
    t.near(map.at(targets[i]).value, wanted[i], rounding * scale, "target ", i);
  for (Index v = 0; v < all.size(); ++v) {
    const Distance distance = map.at(mesh->at_vertex(v));
    if (distance.reach == Reach::reached)
      t.near(distance.value, all[v], rounding * scale, "vertex ", v);
    else
      t.holds(distance.reach == Reach::beyond_limit, "beyond_limit", "vertex ", v);
  }
}

void stopping_saves_work(SolverTrial& t) {
  t.needs(Provides::target_limit);
  const MeshPtr mesh = request_mesh(t);
  Running running(t.plugin, mesh);
  const SurfacePoint near = mesh->at_vertex(1);
  const auto values = running.run({{mesh->at_vertex(0)}}, {.targets = {&near, 1}, .stop_at_targets = true}).vertices();
  t.holds(std::isfinite(values[1]), "the target is reached");
  t.holds(std::any_of(values.begin(), values.end(), [](double d) { return d == infinity; }),
          "what lies far beyond the target is not reached");
}

void no_source(SolverTrial& t) {
  Running running(t.plugin, request_mesh(t));
  t.throws<Error>([&] { running.run({}); });
}

}  // namespace

DemandTable request_demands() {
  return {
      solver_demand<source_vertex>("requests.source", "a source is at distance 0 from itself and names itself"),
      solver_demand<source_anywhere>("requests.source_in_face", "so is one in a face or on an edge"),
      solver_demand<names_of_a_source>("requests.source_names", "the face that names a source does not matter"),
      solver_demand<many_sources>("requests.many_sources",
                                  "many sources give the distance of the nearest, and name it"),
      solver_demand<first_of_two>("requests.first_of_two", "of two sources at one place the first is named"),
      solver_demand<start_distance>("requests.start_distance",
                                    "start distances are added; a late source is reached earlier"),
      solver_demand<radius>("requests.radius", "a radius cuts off, says beyond_limit, and changes nothing within"),
      solver_demand<radius_on_hard_meshes>("requests.radius_hard",
                                           "a radius changes nothing within on hard meshes either"),
      solver_demand<radius_and_components>("requests.radius_components", "unreachable and beyond_limit are told apart"),
      solver_demand<targets_are_kept>("requests.targets", "targets in faces are kept without the whole map"),
      solver_demand<what_was_not_kept>("requests.not_kept", "what was not kept is refused, not guessed"),
      solver_demand<what_is_not_provided>("requests.not_provided", "what is not provided is refused, not guessed"),
      solver_demand<point_off_the_mesh>("requests.off_the_mesh", "a point that is not on the mesh is refused"),
      solver_demand<stop_at_targets>("requests.stop_at_targets", "stopping at targets changes no target"),
      solver_demand<stopping_saves_work>("requests.stopping_saves", "stopping at targets saves work"),
      solver_demand<no_source>("requests.no_source", "no source at all is refused"),
  };
}

}  // namespace geodrome::conformance
