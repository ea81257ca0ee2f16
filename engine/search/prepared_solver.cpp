// SPDX-License-Identifier: MIT
#include "engine/search/prepared_solver.hpp"

#include "engine/formats/remedies.hpp"
#include "engine/formats/text.hpp"
#include "engine/host/stage_context.hpp"
#include "engine/smooth/settling.hpp"

namespace geodrome {

namespace {

/// A capability in words, for those whose name alone says too little.
std::string meaning_of(const CapabilityWord<Provides>& capability) {
  const std::string name = " (" + std::string(capability.word) + ")";
  switch (capability.bit) {
    case Provides::radius_limit:
      return "a largest distance" + name;
    case Provides::face_sources:
      return "sources that are no vertices" + name;
    case Provides::any_point:
      return "distances of points inside faces" + name;
    case Provides::start_distances:
      return "start distances" + name;
    default:
      return capability.word;
  }
}

/// Throws CapabilityError if the mesh lacks what the plugin needs.
void check_needs(const PluginInfo& plugin, const SurfaceMesh& mesh) {
  std::string missing;
  const auto need = [&](Needs bit, bool given, const char* what) {
    if (has(plugin.needs, bit) && !given) append_word(missing, what);
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

/// Throws CapabilityError if the mesh has weights that the plugin would pass over.
void check_weights(const PluginInfo& plugin, const SurfaceMesh& mesh, const PluginHost& host) {
  if (mesh.face_weights().empty() || has(plugin.provides, Provides::weights)) return;
  const std::string able = solvers_with(Provides::weights, host);
  throw CapabilityError(
      plugin.full_name() + " does not measure with weights of faces (weights)",
      able.empty() ? "no solver that is there does; leave the weights out" : "solvers that do: " + able);
}

}  // namespace

void demand(const PluginInfo& solver, Provides wanted) {
  for (const CapabilityWord<Provides>& capability : provides_words)
    if (has(wanted, capability.bit) && !has(solver.provides, capability.bit))
      throw CapabilityError(solver.full_name() + " does not provide " + meaning_of(capability),
                            remedies::solver_that_provides());
}

std::string solvers_with(Provides wanted, const PluginHost& host) {
  std::string names;
  for (const PluginInfo& plugin : host.list().usable)
    if (plugin.stage == ShortestPathSolver::stage && has(plugin.provides, wanted)) append_word(names, plugin.name);
  return names;
}

PreparedSolver prepare_solver(Plugin<ShortestPathSolver> plugin, const MeshPtr& mesh, const PluginHost& host,
                              const RunSettings& settings, Observer& observer) {
  check_needs(plugin.info, *mesh);
  check_weights(plugin.info, *mesh, host);
  StageContext context(ShortestPathSolver::stage, observer, thread_count(settings), settings.seed);
  const Stopwatch watch;
  PreparedSolver solver = prepared_on({std::move(plugin), nullptr, {}}, mesh, context);
  solver.record = {solver.plugin.info, solver.plugin.options, watch.seconds(), context.measures()};
  return solver;
}

std::shared_ptr<const SmoothMetric> metric_of(const PlacedSurface& surface) {
  if (!surface.smooth) return nullptr;
  const PluginInfo& plugin = surface.smooth->record.plugin;
  return cross_boundary(plugin, [&] {
    return std::make_shared<const SmoothMetric>(plugin, SmoothCharts(surface.mesh, surface.smooth->surface));
  });
}

void settle_places(PlacedSurface& surface) {
  std::vector<SettledPoint> points;
  const auto each = [&](auto&& use) {
    for (Place& place : surface.places)
      if (place.state == Place::State::on_surface && place.vertex == no_index) use(place);
  };
  each([&](const Place& place) { points.push_back({place.position, place.at}); });
  cross_boundary(surface.smooth->record.plugin,
                 [&] { settle(SmoothCharts(surface.mesh, surface.smooth->surface), points); });
  auto point = points.begin();
  each([&](Place& place) { place.at = (point++)->at; });
}

PreparedSolver prepared_on(const PreparedSolver& solver, const MeshPtr& mesh, RunContext& context) {
  PreparedSolver result = solver;
  result.smooth = nullptr;  // it is of the other surface
  result.prepared = solver.plugin.call([&](const ShortestPathSolver& stage) { return stage.prepare(mesh, context); });
  if (!result.prepared) throw PluginError(solver.plugin.info.full_name() + ": prepared nothing");
  return result;
}

std::unique_ptr<Search> make_search(const PreparedSolver& solver) {
  return cross_boundary(solver.plugin.info, [&] { return solver.prepared->make_search(); });
}

const ShortestPathMap& run_search(const PreparedSolver& solver, Search& search, std::span<const Source> sources,
                                  const Request& request, RunContext& context) {
  return cross_boundary(solver.plugin.info,
                        [&]() -> const ShortestPathMap& { return search.run(sources, request, context); });
}

}  // namespace geodrome
