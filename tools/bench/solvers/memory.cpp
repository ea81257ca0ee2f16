// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/memory.hpp"

#include <malloc.h>

#include "engine/report/memory.hpp"
#include "tools/bench/solvers/runner.hpp"

namespace geodrome::bench {

SearchMemory search_memory(const Plugin<ShortestPathSolver>& solver, const MeshPtr& mesh, Index source, Keep keep) {
  if (keep == Keep::map && !has(solver.info.provides, Provides::any_point) &&
      !has(solver.info.provides, Provides::paths))
    throw CapabilityError(solver.info.full_name() + " keeps no map: it provides neither any_point nor paths");
  SolverRunner runner(solver, mesh);
  // What reading the mesh has freed but not returned would be used by the solver without being seen.
  malloc_trim(0);
  reset_memory_peak();
  SearchMemory memory;
  memory.before = memory_now();
  runner.prepare();
  runner.make_search();
  runner.query(source, keep);
  memory.peak = memory_peak();
  memory.prepared = runner.prepared_bytes();
  memory.search = runner.figures().bytes;
  return memory;
}

}  // namespace geodrome::bench
