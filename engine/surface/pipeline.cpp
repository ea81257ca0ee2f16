// SPDX-License-Identifier: MIT
#include "geodrome/engine/pipeline.hpp"
#include "engine/formats/remedies.hpp"

#include <algorithm>
#include <thread>

#include "engine/host/stage_context.hpp"
#include "engine/surface/sample_chain.hpp"

namespace geodrome {

namespace {

Place place_of_vertex(const SurfaceMesh& mesh, Index vertex) {
  if (vertex == no_index) return {};
  if (mesh.first_half_edge(vertex) == no_index) return {Place::State::isolated, {}, vertex, mesh.positions()[vertex]};
  return {Place::State::on_surface, mesh.at_vertex(vertex), vertex, mesh.positions()[vertex]};
}

PlacedSurface surface_of_mesh(const Input& input) {
  PlacedSurface surface;
  surface.made_from = InputKind::mesh;
  if (input.triangles.empty())
    throw InputError(InputFault::degenerate, input.file.string() + ": no face with an area is left");
  surface.mesh = std::make_shared<const SurfaceMesh>(input.positions, input.triangles, input.weights);
  for (const Index vertex : input.element_of_row) surface.places.push_back(place_of_vertex(*surface.mesh, vertex));
  return surface;
}

/// Throws CapabilityError if the mesh lacks what the plugin needs.
void check_needs(const PluginInfo& plugin, const SurfaceMesh& mesh) {
  std::string missing;
  const auto need = [&](Needs bit, bool given, const char* what) {
    if (has(plugin.needs, bit) && !given) missing += (missing.empty() ? "" : ", ") + std::string(what);
  };
  need(Needs::manifold, mesh.manifold(),
       "nonmanifold (an edge with over two faces, or a vertex where several fans meet)");
  need(Needs::oriented, !mesh.manifold() || mesh.oriented(),
       "not oriented (not orientable, or neighbouring faces that clash)");
  need(Needs::closed, mesh.closed(), "not closed");
  if (missing.empty()) return;
  throw CapabilityError(plugin.full_name() + " cannot work on this surface: " + missing,
                        remedies::solver_that_needs_less());
}

/// The solvers that measure with weights, as a remedy. It tries every plugin, which takes seconds at worst.
std::string weighted_solvers(const PluginHost& host) {
  std::string names;
  for (const PluginInfo& plugin : host.list().usable)
    if (plugin.stage == ShortestPathSolver::stage && has(plugin.provides, Provides::weights))
      names += (names.empty() ? "" : ", ") + plugin.name;
  return names.empty() ? "no solver that is there does; leave the weights out" : "solvers that do: " + names;
}

/// Throws CapabilityError if the mesh has weights that the plugin would pass over.
void check_weights(const PluginInfo& plugin, const SurfaceMesh& mesh, const PluginHost& host) {
  if (mesh.face_weights().empty() || has(plugin.provides, Provides::weights)) return;
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
  return SampleChain(input, host, settings, observer).make(settings.stages);
}

PlacedSurface make_surface(const Input& input, const PluginHost& host, const RunSettings& settings,
                           Observer& observer) {
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
