// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/runner.hpp"

#include "tools/shapes/random.hpp"

namespace geodrome::bench {

void require_needs(const PluginInfo& solver, const SurfaceMesh& mesh) {
  const auto demand = [&](Needs bit, bool given, const char* what) {
    if (has(solver.needs, bit) && !given)
      throw CapabilityError(solver.full_name() + " needs a surface that is " + what);
  };
  demand(Needs::manifold, mesh.manifold(), "manifold");
  demand(Needs::oriented, mesh.oriented(), "oriented");
  demand(Needs::closed, mesh.closed(), "closed");
}

SolverRunner::SolverRunner(Plugin<ShortestPathSolver> plugin, MeshPtr mesh)
    : plugin_(std::move(plugin)), mesh_(std::move(mesh)) {
  require_needs(plugin_.info, *mesh_);
}

double SolverRunner::prepare() {
  search_.reset();
  prepared_.reset();
  return processor_seconds_of([&] {
    prepared_ = plugin_.call([&](const ShortestPathSolver& solver) { return solver.prepare(mesh_, context_); });
  });
}

double SolverRunner::make_search() {
  search_.reset();
  return processor_seconds_of(
      [&] { search_ = plugin_.call([&](const ShortestPathSolver&) { return prepared_->make_search(); }); });
}

double SolverRunner::query(Index vertex, Keep keep) {
  const Source source{mesh_->at_vertex(vertex), 0};
  Request request;
  request.keep = keep;
  const ShortestPathMap* map = nullptr;
  const double time = processor_seconds_of([&] {
    plugin_.call([&](const ShortestPathSolver&) {
      map = &search_->run({&source, 1}, request, context_);
      const auto values = map->vertices();
      distances_.assign(values.begin(), values.end());
    });
  });
  plugin_.call([&](const ShortestPathSolver&) { figures_ = figures_of(map->counters()); });
  return time;
}

SolverRunner SolverRunner::shared() const {
  SolverRunner other(plugin_, mesh_);
  other.prepared_ = prepared_;
  return other;
}

std::vector<Index> choose_sources(const SurfaceMesh& mesh, std::size_t count, std::uint64_t seed) {
  if (mesh.face_count() == 0) throw InputError(InputFault::empty, "the mesh has no face");
  shapes::Random random(seed);
  std::vector<Index> sources;
  for (std::size_t i = 0; i < count; ++i)
    sources.push_back(mesh.triangles()[random.index(mesh.face_count())][random.index(3)]);
  return sources;
}

}  // namespace geodrome::bench
