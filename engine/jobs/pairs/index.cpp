// SPDX-License-Identifier: MIT
#include "engine/jobs/pairs/index.hpp"

#include "engine/formats/remedies.hpp"
#include "engine/host/stage_context.hpp"
#include "engine/output/index_file.hpp"
#include "engine/output/posix_file.hpp"

namespace geodrome {

namespace {

std::unique_ptr<const PairOracle> make_oracle(const PreparedSolver& solver, std::istream* saved, RunContext& context) {
  std::unique_ptr<const PairOracle> oracle =
      cross_boundary(solver.plugin.info, [&] { return solver.prepared->pair_oracle(saved, context); });
  if (oracle) return oracle;
  throw PluginError(solver.plugin.info.full_name() + ": provides pair_queries and made no oracle",
                    "report this to the author of " + solver.plugin.info.file.string());
}

/// A job that made the same file meanwhile was first: its file stays.
void save(ReadyOracle& ready, const PreparedSolver& solver, const std::filesystem::path& index,
          const IndexIdentity& identity, Observer& observer) {
  if (file_exists(index)) {
    observer.log(LogLevel::warning, index.string() + " appeared while the index was built, and was left as it is");
    return;
  }
  const Stopwatch watch;
  ready.index_bytes = write_index(index, identity, [&](std::ostream& out) {
    cross_boundary(solver.plugin.info, [&] { ready.oracle->save(out); });
  });
  ready.was_saved = true;
  ready.save_seconds = watch.seconds();
}

}  // namespace

void demand_pair_queries(const PluginInfo& solver, const PluginHost& host) {
  if (has(solver.provides, Provides::pair_queries)) return;
  throw CapabilityError(solver.full_name() + " does not provide distances of arbitrary pairs (pair_queries)",
                        remedies::solver_of_pairs(solvers_with(Provides::pair_queries, host)));
}

ReadyOracle ready_oracle(const SurfaceMesh& mesh, const PreparedSolver& solver, const std::filesystem::path& index,
                         const RunSettings& settings, Observer& observer) {
  StageContext context("oracle", observer, thread_count(settings), settings.seed);
  ReadyOracle ready;
  if (index.empty()) {
    const Stopwatch watch;
    ready.oracle = make_oracle(solver, nullptr, context);
    ready.seconds = watch.seconds();
    return ready;
  }
  const IndexIdentity identity = identity_of(mesh, solver.plugin.info, solver.plugin.options, settings.seed);
  ready.was_read = file_exists(index);
  const Stopwatch watch;
  if (ready.was_read) {
    TextInput saved = open_index(index, identity);
    ready.index_bytes = saved.view().size();
    ready.oracle = make_oracle(solver, &saved, context);
  } else {
    ready.oracle = make_oracle(solver, nullptr, context);
  }
  ready.seconds = watch.seconds();
  context.throw_if_cancelled();
  if (!ready.was_read) save(ready, solver, index, identity, observer);
  return ready;
}

}  // namespace geodrome
