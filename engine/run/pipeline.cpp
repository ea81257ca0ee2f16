// SPDX-License-Identifier: MIT
#include "geodrome/engine/pipeline.hpp"

#include <algorithm>
#include <thread>

#include "engine/report/input_rows.hpp"
#include "engine/run/stage_context.hpp"

namespace geodrome {

namespace {

/// Runs one stage: loads its plugin, times the call, keeps the record, also of a stage that refuses the sample.
template <class Stage, class Function>
auto run_stage(const std::string& selection, const PluginHost& host, const RunSettings& settings, Observer& observer,
               std::vector<StageRecord>& records, Function&& function) {
  const Plugin<Stage> plugin = host.load<Stage>(selection);
  StageContext context(Stage::stage, observer, thread_count(settings), settings.seed);
  const Stopwatch watch;
  const auto record = [&] { records.push_back({plugin.info, plugin.options, watch.seconds(), context.measures()}); };
  try {
    auto result = plugin.call([&](const Stage& stage) { return function(stage, context, plugin.info); });
    context.throw_if_cancelled();
    record();
    return result;
  } catch (const SampleError&) {
    record();
    throw;
  }
}

/// A plugin may be anybody's: a result that breaks the interface must not travel on.
void demand(bool holds, const PluginInfo& plugin, const char* what) {
  if (!holds)
    throw PluginError(std::string("returned ") + what, "report this to the author of " + plugin.file.string());
}

void check(const Tangents& tangents, std::size_t n, const PluginInfo& plugin) {
  demand(tangents.plane.size() == n && tangents.state.size() == n, plugin, "not one tangent plane and state per point");
  for (std::size_t i = 0; i < n; ++i)
    demand(tangents.state[i] == PointState::dropped ||
               (is_finite(tangents.plane[i].origin) && is_finite(tangents.plane[i].normal)),
           plugin, "a tangent plane that is not finite");
}

void check(const Control& control, std::size_t n, const PluginInfo& plugin) {
  demand(control.phi.size() == n && control.psi.size() == n && control.state.size() == n, plugin,
         "not one phi, psi and state per point");
  for (std::size_t i = 0; i < n; ++i)
    demand(control.state[i] == PointState::dropped || (control.psi[i] > 0 && std::isfinite(control.psi[i])), plugin,
           "a psi that is not positive and finite");
}

void check(const std::vector<Index>& kept, std::size_t n, const PluginInfo& plugin) {
  const bool ascending = std::adjacent_find(kept.begin(), kept.end(), std::greater_equal<>()) == kept.end();
  demand(ascending && (kept.empty() || kept.back() < n), plugin,
         "kept points that are not ascending indices of points");
}

void check(const Reconstruction& made, std::size_t n, const PluginInfo& plugin) {
  demand(made.mesh != nullptr && made.mesh->face_count() > 0, plugin, "no surface");
  demand(made.sample_of_vertex.size() == made.mesh->vertex_count(), plugin, "not one sample point per vertex");
  for (const Index s : made.sample_of_vertex)
    demand(s == no_index || s < n, plugin, "a sample point that is not there");
  demand(made.mesh->manifold() && made.mesh->oriented(), plugin, "a surface that is no oriented 2-manifold");
  // D >= |st| would not hold there, and nobody asked for them.
  demand(made.mesh->face_weights().empty(), plugin, "a surface with weights");
}

Place place_of_vertex(const SurfaceMesh& mesh, Index vertex) {
  if (vertex == no_index) return {};
  if (mesh.first_half_edge(vertex) == no_index) return {Place::State::isolated, {}, vertex, mesh.positions()[vertex]};
  return {Place::State::on_surface, mesh.at_vertex(vertex), vertex, mesh.positions()[vertex]};
}

Surface surface_of_mesh(const Input& input) {
  Surface surface;
  surface.made_from = InputKind::mesh;
  if (input.triangles.empty())
    throw InputError(InputFault::degenerate, input.file.string() + ": no face with an area is left");
  surface.mesh = std::make_shared<const SurfaceMesh>(input.positions, input.triangles, input.weights);
  for (const Index vertex : input.element_of_row) surface.places.push_back(place_of_vertex(*surface.mesh, vertex));
  return surface;
}

/// What stages 2 to 4 work on: the sample as stage 1 left it.
PointSample smoothed(const PointSample& sample, const Tangents& tangents) {
  PointSample result = sample;
  for (std::size_t i = 0; i < result.size(); ++i)
    if (tangents.state[i] != PointState::dropped) result.points[i] = tangents.plane[i].origin;
  return result;
}

/// Stages 1 to 3, into `made`.
void run_sample_stages(const PointSample& sample, const PluginHost& host, const RunSettings& settings,
                       Observer& observer, std::vector<StageRecord>& records, SampleStages& made) {
  const std::size_t n = sample.size();
  made.tangents =
      run_stage<TangentEstimator>(settings.stages.tangent, host, settings, observer, records,
                                  [&](const TangentEstimator& stage, RunContext& context, const PluginInfo& plugin) {
                                    Tangents tangents = stage.estimate(sample, context);
                                    check(tangents, n, plugin);
                                    return tangents;
                                  });
  made.smoothed = smoothed(sample, made.tangents);
  made.control =
      run_stage<ControlFunction>(settings.stages.control, host, settings, observer, records,
                                 [&](const ControlFunction& stage, RunContext& context, const PluginInfo& plugin) {
                                   Control control = stage.evaluate(made.smoothed, made.tangents, context);
                                   check(control, n, plugin);
                                   return control;
                                 });
  made.kept = run_stage<Decimator>(settings.stages.decimator, host, settings, observer, records,
                                   [&](const Decimator& stage, RunContext& context, const PluginInfo& plugin) {
                                     std::vector<Index> kept = stage.select(made.smoothed, made.control, context);
                                     check(kept, n, plugin);
                                     return kept;
                                   });
}

/// Stages count points, users count rows: two numbers where rows were merged or dropped.
void name_rows(std::vector<Finding>& findings, const std::vector<Index>& row_of) {
  for (Finding& finding : findings)
    for (Index& element : finding.elements)
      if (element < row_of.size() && row_of[element] != no_index) element = row_of[element];
}

/// Every row's closest surface point (Algorithm 2, lines 16 to 19, corrected).
std::vector<Place> project(const Input& input, const SurfaceLocator& locator, const SurfaceMesh& mesh,
                           const Control& control) {
  std::vector<Place> of_point(input.positions.size());
  for (std::size_t i = 0; i < of_point.size(); ++i) {
    of_point[i].position = input.positions[i];
    if (control.state[i] == PointState::dropped) continue;
    const SurfacePoint at = locator.closest(input.positions[i]).at;
    of_point[i] = {Place::State::on_surface, at, mesh.vertex_at(at), input.positions[i]};
  }
  std::vector<Place> of_row;
  for (const Index i : input.element_of_row) of_row.push_back(i == no_index ? Place{} : of_point[i]);
  return of_row;
}

/// Stage 4, and the places of the points.
void reconstruct(const Input& input, const PluginHost& host, const RunSettings& settings, Observer& observer,
                 Surface& surface) {
  SampleStages& stages = *surface.sample;
  Reconstruction made = run_stage<SurfaceReconstructor>(
      settings.stages.reconstructor, host, settings, observer, surface.stages,
      [&](const SurfaceReconstructor& stage, RunContext& context, const PluginInfo& plugin) {
        Reconstruction result =
            stage.reconstruct(stages.smoothed, stages.tangents, stages.control, stages.kept, context);
        check(result, input.positions.size(), plugin);
        return result;
      });
  stages.sample_of_vertex = std::move(made.sample_of_vertex);
  surface.mesh = std::move(made.mesh);
  surface.findings = std::move(made.findings);
  surface.inserter = std::move(made.inserter);
  name_rows(surface.findings, rows_of_elements(input));
  surface.locator = std::make_shared<const SurfaceLocator>(surface.mesh);
  surface.places = project(input, *surface.locator, *surface.mesh, stages.control);
}

SurfaceAttempt attempt_points(const Input& input, const PluginHost& host, const RunSettings& settings,
                              Observer& observer) {
  SurfaceAttempt attempt;
  Surface& surface = attempt.surface;
  surface.made_from = InputKind::points;
  surface.sample.emplace();
  try {
    run_sample_stages(PointSample{input.positions}, host, settings, observer, surface.stages, *surface.sample);
    reconstruct(input, host, settings, observer, surface);
  } catch (const SampleError& error) {
    std::vector<Finding> findings = error.findings();
    name_rows(findings, rows_of_elements(input));
    attempt.refusal.emplace(error.message(), error.remedy(), std::move(findings));
    attempt.refusal->attribute_to(error.plugin());
  }
  return attempt;
}

/// Throws CapabilityError if the mesh lacks what the plugin needs.
void check_needs(const PluginInfo& plugin, const SurfaceMesh& mesh) {
  std::string missing;
  const auto need = [&](Needs bit, bool has, const char* what) {
    if ((plugin.needs & bit) && !has) missing += (missing.empty() ? "" : ", ") + std::string(what);
  };
  need(manifold, mesh.manifold(), "nonmanifold (an edge with over two faces, or a vertex where several fans meet)");
  need(oriented, !mesh.manifold() || mesh.oriented(),
       "not oriented (not orientable, or neighbouring faces that clash)");
  need(closed, mesh.closed(), "not closed");
  if (missing.empty()) return;
  throw CapabilityError(plugin.full_name() + " cannot work on this surface: " + missing,
                        "repair the mesh, or choose a solver that needs less ('geodrome plugins show NAME' tells)");
}

/// The solvers that measure with weights, as a remedy. It tries every plugin, which takes seconds at worst.
std::string weighted_solvers(const PluginHost& host) {
  std::string names;
  for (const PluginInfo& plugin : host.list().usable)
    if (plugin.stage == ShortestPathSolver::stage && (plugin.provides & weights))
      names += (names.empty() ? "" : ", ") + plugin.name;
  return names.empty() ? "no solver that is there does; leave the weights out" : "solvers that do: " + names;
}

/// Throws CapabilityError if the mesh has weights that the plugin would pass over.
void check_weights(const PluginInfo& plugin, const SurfaceMesh& mesh, const PluginHost& host) {
  if (mesh.face_weights().empty() || (plugin.provides & weights)) return;
  throw CapabilityError(plugin.full_name() + " does not measure with weights of faces (weights)",
                        weighted_solvers(host));
}

}  // namespace

unsigned thread_count(const RunSettings& settings) {
  return settings.threads > 0 ? settings.threads : std::max(1u, std::thread::hardware_concurrency());
}

SurfaceAttempt try_surface(const Input& input, const PluginHost& host, const RunSettings& settings,
                           Observer& observer) {
  if (input.kind == InputKind::mesh) return {surface_of_mesh(input), std::nullopt};
  return attempt_points(input, host, settings, observer);
}

Surface make_surface(const Input& input, const PluginHost& host, const RunSettings& settings, Observer& observer) {
  SurfaceAttempt attempt = try_surface(input, host, settings, observer);
  if (attempt.refusal) throw *attempt.refusal;
  return std::move(attempt.surface);
}

PreparedSolver prepare_solver(MeshPtr mesh, const PluginHost& host, const std::string& selection,
                              const RunSettings& settings, Observer& observer) {
  PreparedSolver solver;
  solver.plugin = host.load<ShortestPathSolver>(selection);
  check_needs(solver.plugin.info, *mesh);
  check_weights(solver.plugin.info, *mesh, host);
  StageContext context(ShortestPathSolver::stage, observer, thread_count(settings), settings.seed);
  const Stopwatch watch;
  solver.prepared = solver.plugin.call([&](const ShortestPathSolver& stage) { return stage.prepare(mesh, context); });
  if (!solver.prepared) throw PluginError(solver.plugin.info.full_name() + ": prepared nothing");
  solver.record = {solver.plugin.info, solver.plugin.options, watch.seconds(), context.measures()};
  return solver;
}

}  // namespace geodrome
