// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "engine/search/prepared_solver.hpp"

namespace geodrome {

/// A pair oracle and where it came from. Must not outlive the solver that it was made with.
struct ReadyOracle {
  std::unique_ptr<const PairOracle> oracle;
  bool was_read = false;   ///< from the index file; else built
  bool was_saved = false;  ///< into the index file
  double seconds = 0;      ///< of building or reading
  double save_seconds = 0;
  std::uint64_t index_bytes = 0;  ///< of the file that was read or saved
};

/// Throws CapabilityError unless the solver provides pair_queries, naming those of the host that do.
void demand_pair_queries(const PluginInfo& solver, const PluginHost& host);

/// Reads the oracle from `index` if that is there, else builds it and, if `index` is not empty, saves it there: at
/// once, so that it is not lost with what comes after. A file that is there is never changed. Throws InputError for one
/// that does not belong to this mesh, solver, options and seed or is damaged (`open_index`), Cancelled, and what the
/// plugin throws.
ReadyOracle ready_oracle(const SurfaceMesh& mesh, const PreparedSolver& solver, const std::filesystem::path& index,
                         const RunSettings& settings, Observer& observer);

}  // namespace geodrome
