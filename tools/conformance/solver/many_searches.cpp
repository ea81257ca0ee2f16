// SPDX-License-Identifier: MIT
// The extension ManySearches: a surface that a solver made for a plan of searches answers as the one before did.
#include "geodrome/many_searches.hpp"

#include <algorithm>
#include <filesystem>

#include "geodrome/engine/input.hpp"

#include "tools/conformance/solver/path_trial.hpp"
#include "tools/shapes/fuzz_mesh.hpp"

namespace geodrome::conformance {
namespace {

const ManySearches& table_of(const SolverTrial& t) {
  const auto* table = t.plugin.extension<ManySearches>();
  if (!table) throw NotApplicable{"the solver prepares no searches together"};
  return *table;
}

std::vector<SurfacePoint> all_vertices(const SurfaceMesh& mesh) {
  std::vector<SurfacePoint> points;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.first_half_edge(v) != no_index) points.push_back(mesh.at_vertex(v));
  return points;
}

/// A surface made for a plan beside the plain one.
struct Planned {
  Running plain;
  std::unique_ptr<PreparedSurface> prepared;  ///< null: it would not pay
  std::unique_ptr<Search> search;

  Planned(const SolverTrial& t, const MeshPtr& mesh, const std::vector<SurfacePoint>& sources, double radius = infinity,
          unsigned threads = 1)
      : plain(t.plugin, mesh) {
    Threads context(threads);
    prepared = table_of(t).prepare(*plain.prepared, {sources, radius}, context);
    if (prepared) search = prepared->make_search();
  }

  const ShortestPathMap& run(const std::vector<Source>& sources, const Request& request = {}) {
    return search->run(sources, request, plain.context);
  }
};

/// The plan of a trial on one mesh. Leaves the demand where the solver finds that it would not pay.
Planned planned_or_leave(const SolverTrial& t, const MeshPtr& mesh, const std::vector<SurfacePoint>& sources,
                         double radius = infinity) {
  Planned planned(t, mesh, sources, radius);
  if (!planned.prepared) throw NotApplicable{"the solver finds that to prepare searches together would not pay here"};
  return planned;
}

MeshPtr usual_mesh(const SolverTrial& t) {
  const MeshPtr mesh = terrain(11, 1.5, 61);
  t.needs_fit(mesh);
  return mesh;
}

/// Two answers of one request agree: both finite or, except from the limit on, neither.
template <class... Where>
void judge_distance(SolverTrial& t, double found, double plain, double limit, double scale, const Where&... where) {
  const double slack = rounding * scale, least = std::min(found, plain);
  if (least >= limit - slack && std::max(found, plain) == infinity) return t.holds(true, "on the limit", where...);
  t.near(found, plain, slack, where...);
}

/// A request of both surfaces. `points`: what else may be asked.
template <class... Where>
void judge_request(SolverTrial& t, Planned& planned, const std::vector<Source>& sources, const Request& request,
                   const std::vector<SurfacePoint>& points, const Where&... where) {
  const ShortestPathMap &plain = planned.plain.run(sources, request), &found = planned.run(sources, request);
  const double scale = largest_finite(plain.vertices());
  double limit = request.radius;
  if (request.stop_at_targets)
    for (const SurfacePoint& target : request.targets) limit = std::min(limit, plain.at(target).value);
  for (std::size_t v = 0; v < plain.vertices().size(); ++v)
    judge_distance(t, found.vertices()[v], plain.vertices()[v], limit, scale, where..., ", vertex ", v);
  for (const SurfacePoint& point : points) {
    const Distance distance = found.at(point), wanted = plain.at(point);
    judge_distance(t, distance.value, wanted.value, limit, scale, where..., ", face ", point.face);
    if (std::isfinite(distance.value) == std::isfinite(wanted.value))
      t.holds(distance.reach == wanted.reach, "the reach of the plain search", where..., ", face ", point.face);
    t.holds(distance.reach != Reach::reached || distance.source < sources.size(), "one of the sources is named",
            where..., ", face ", point.face);
  }
}

/// A dozen rows of all vertices; returns whether the solver finds that it pays.
bool judge_some_rows(SolverTrial& t, const MeshPtr& mesh) {
  const std::vector<SurfacePoint> sources = all_vertices(*mesh);
  Planned planned(t, mesh, sources);
  if (!planned.prepared) return false;
  for (std::size_t i = 0; i < sources.size(); i += 1 + sources.size() / 12)
    judge_request(t, planned, {{sources[i]}}, {}, {sources[0], sources[i]}, mesh->face_count(), " faces, source ", i);
  return true;
}

void meshes(SolverTrial& t) {
  table_of(t);
  std::vector<MeshPtr> meshes{
      terrain(14, 2, 91), bumpy_torus(24, 12, 0.1, 93), both(cube(), terrain(9, 2, 95)), bow_tie(), book(),
      moebius(12)};
  for (const std::uint64_t seed : {1, 7, 24, 42, 115, 262, 344})
    meshes.push_back(std::make_shared<const SurfaceMesh>(shapes::fuzz_mesh(seed).mesh));
  bool paid = false;
  for (const MeshPtr& mesh : meshes) {
    if (!t.fits(*mesh) || mesh->face_count() == 0 || mesh->face_count() > 1500) continue;
    paid |= judge_some_rows(t, mesh);
  }
  if (!paid) throw NotApplicable{"the solver finds that to prepare searches together would not pay on small meshes"};
}

void given(SolverTrial& t) {
  table_of(t);
  if (t.subject.meshes.empty()) throw NotApplicable{"no mesh was given"};
  bool paid = false;
  for (const std::filesystem::path& file : t.subject.meshes) {
    Input input = read_input(file, {.as = InputKind::mesh});
    const auto mesh = std::make_shared<const SurfaceMesh>(std::move(input.positions), std::move(input.triangles));
    t.holds(t.fits(*mesh), "a mesh that fits the solver's needs", file.string());
    paid |= judge_some_rows(t, mesh);
  }
  if (!paid) throw NotApplicable{"the solver finds that to prepare searches together would not pay on these meshes"};
}

void requests(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh(t);
  Planned planned = planned_or_leave(t, mesh, all_vertices(*mesh));
  std::mt19937_64 random(67);
  std::vector<SurfacePoint> points{mesh->at_vertex(26)};
  if (t.has(Provides::any_point))
    for (int i = 0; i < 20; ++i) points.push_back(random_point(*mesh, random));
  std::vector<Source> one{{mesh->at_vertex(20)}}, several{{mesh->at_vertex(3)}, {mesh->at_vertex(77)}};
  if (t.has(Provides::start_distances)) several[1].start = 0.5;
  if (t.has(Provides::face_sources)) several.push_back({random_point(*mesh, random)});
  const std::vector<Source> last{several.back()};
  for (const auto& sources : {one, several, last}) {
    judge_request(t, planned, sources, {.targets = points}, points, "targets");
    judge_request(t, planned, sources, {.keep = Keep::map}, points, "any point");
    if (t.has(Provides::radius_limit))
      for (const double radius : {0.0, 2.0, 5.0})
        judge_request(t, planned, sources, {.radius = radius, .targets = points}, points, "radius ", radius);
    if (t.has(Provides::target_limit))
      judge_request(t, planned, sources, {.targets = {points.data(), 1}, .stop_at_targets = true}, {},
                    "stop at a target");
  }
}

void paths(SolverTrial& t) {
  t.needs(Provides::paths);
  const MeshPtr mesh = usual_mesh(t);
  Planned planned = planned_or_leave(t, mesh, all_vertices(*mesh));
  const CommonFace common(*mesh);
  std::mt19937_64 random(73);
  for (const Index v : {3, 60, 140}) {
    const ShortestPathMap& map = planned.run({{mesh->at_vertex(v)}}, {.keep = Keep::map});
    for (int i = 0; i < 30; ++i) {
      const bool anywhere = t.has(Provides::any_point) && i % 2 == 0;
      const SurfacePoint point =
          anywhere ? random_point(*mesh, random) : mesh->at_vertex(static_cast<Index>(random() % mesh->vertex_count()));
      judge_path(t, *mesh, common, map, point, {mesh->at_vertex(v)}, 15);
    }
  }
}

/// Of few sources, of short searches: whatever the plan does not hold is answered too.
void other_plans(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh(t);
  std::mt19937_64 random(79);
  std::vector<SurfacePoint> few{mesh->at_vertex(5), mesh->at_vertex(60), mesh->at_vertex(140)};
  if (t.has(Provides::face_sources)) few.push_back(random_point(*mesh, random));
  bool paid = false;
  for (const auto& [sources, radius] :
       {std::pair(few, infinity), std::pair(few, 3.0), std::pair(all_vertices(*mesh), 3.0)}) {
    Planned planned(t, mesh, sources, radius);
    if (!planned.prepared) continue;
    paid = true;
    for (const SurfacePoint& at : {few[0], few.back(), mesh->at_vertex(99)})
      for (const double within : {infinity, 3.0, 1.0})
        if (within == infinity || t.has(Provides::radius_limit))
          judge_request(t, planned, {{at}}, {.radius = within}, {mesh->at_vertex(0)}, "a plan of ", sources.size(),
                        " searches up to ", radius, ", face ", at.face, " up to ", within);
  }
  if (!paid) throw NotApplicable{"the solver finds that to prepare searches together would not pay here"};
}

void threads(SolverTrial& t) {
  table_of(t);
  for (const MeshPtr& mesh : {usual_mesh(t), bumpy_torus(24, 12, 0.1, 93)}) {
    if (!t.fits(*mesh)) continue;
    Planned one(t, mesh, all_vertices(*mesh), infinity, 1), two(t, mesh, all_vertices(*mesh), infinity, 2);
    t.equal(one.prepared != nullptr, two.prepared != nullptr, "whether it pays, with 1 and 2 threads");
    if (!one.prepared || !two.prepared) continue;
    for (Index v = 0; v < mesh->vertex_count(); v += 7)
      t.holds(same_bytes(one.run({{mesh->at_vertex(v)}}).vertices(), two.run({{mesh->at_vertex(v)}}).vertices()),
              "the same bytes with 1 and 2 threads", "vertex ", v);
  }
}

void used_again(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh(t);
  Planned planned = planned_or_leave(t, mesh, all_vertices(*mesh));
  const std::vector<double> fresh = copy(planned.run({{mesh->at_vertex(70)}}).vertices());
  const auto other = planned.prepared->make_search();
  const Source source{mesh->at_vertex(99)};
  other->run({&source, 1}, {.keep = Keep::map}, planned.plain.context);
  planned.run({{mesh->at_vertex(3)}, {mesh->at_vertex(40)}}, {.keep = Keep::map});
  if (t.has(Provides::radius_limit)) planned.run({source}, {.radius = 2});
  t.holds(same_bytes(planned.run({{mesh->at_vertex(70)}}).vertices(), fresh),
          "a used search gives the bytes of a fresh one");
}

void cancelled(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh(t);
  Planned planned = planned_or_leave(t, mesh, all_vertices(*mesh));
  const std::vector<SurfacePoint> sources = all_vertices(*mesh);
  CancelAfter at_once(0);
  t.throws<Cancelled>([&] { table_of(t).prepare(*planned.plain.prepared, {sources}, at_once); }, "preparing");
  const std::vector<double> before = copy(planned.run({{sources[7]}}).vertices());
  const Source source{sources[0]};
  t.throws<Cancelled>([&] { planned.search->run({&source, 1}, {}, at_once); }, "a search that is cancelled at once");
  t.holds(same_bytes(planned.run({{sources[7]}}).vertices(), before), "the search works afterwards");
}

void bytes_held(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh(t);
  const Planned planned = planned_or_leave(t, mesh, all_vertices(*mesh));
  t.at_least(static_cast<double>(planned.prepared->bytes()), static_cast<double>(planned.plain.prepared->bytes()),
             "bytes, with those of the surface that it was made from");
}

}  // namespace

DemandTable many_search_demands() {
  return {
      solver_demand<meshes>("together.meshes", "searches prepared together give the distances of plain ones"),
      solver_demand<given>("together.given", "so they do on the meshes that were given"),
      solver_demand<requests>("together.requests", "so they do for sources, targets and limits of all kinds"),
      solver_demand<paths>("together.paths", "their paths run on the surface, as long as the distance"),
      solver_demand<other_plans>("together.other_plans", "what a plan does not hold is answered too"),
      solver_demand<threads>("together.threads", "the number of threads changes no byte and no choice"),
      solver_demand<used_again>("together.used_again", "a search used before gives the same bytes as a new one"),
      solver_demand<cancelled>("together.cancelled", "preparing and searching can be cancelled"),
      solver_demand<bytes_held>("together.bytes", "the size told counts what was prepared before"),
  };
}

}  // namespace geodrome::conformance
