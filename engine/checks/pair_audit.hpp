// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/checks/invariants.hpp"
#include "engine/search/prepared_solver.hpp"
#include "geodrome/engine/named_points.hpp"

namespace geodrome {

/// A few pairs of a job, searched for anew.
struct PairAudit {
  std::string not_audited;  ///< the reason, empty if it was
  std::size_t pairs = 0;
  /// The largest of D - factor S and S - factor D where S is what a search found, over the largest coordinate or
  /// distance; at least 0. Both are at least the true distance and at most `factor` times that, so neither may be above
  /// 0 by more than rounding.
  double worst = 0;
  std::size_t worst_pair = 0;

  bool holds() const { return worst <= float64_tolerance; }
};

/// Searches by the same solver, without its oracle, for up to three pairs (the first, the middle, the last of those
/// that are reached and of which a factor is promised), from either end where the solver can. `values`: surface
/// distances, one a pair; `bounded`: or, if longer, the straight line. Throws what the solver throws.
PairAudit audit_pairs(const SurfaceMesh& mesh, const PreparedSolver& solver, std::span<const NamedPair> pairs,
                      std::span<const double> values, RunContext& context, bool bounded = false);

/// The line of an audit that found a promise broken by `pair`, none if it found none.
std::vector<std::string> broken_promises(const PairAudit& audit, std::size_t pair);

}  // namespace geodrome
