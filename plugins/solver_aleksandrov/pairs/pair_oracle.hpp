// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <memory>

#include "geodrome/shortest_path_solver.hpp"
#include "plugins/solver_aleksandrov/discretization.hpp"

namespace geodrome::aleksandrov {

/// Makes the oracle for distances of arbitrary pairs within a factor of 1 + delta, from an index that is built, or read
/// from `saved` if that is not null. Pairs that the index does not settle are answered by a search with `exact`, an
/// exact solver, no farther than the index's upper bound. The surface of `discretization` and the code of `exact`
/// outlive the oracle. Throws CapabilityError for face weights; see PairIndex for the rest.
std::unique_ptr<PairOracle> make_pair_oracle(std::shared_ptr<const Discretization> discretization, double delta,
                                             const ShortestPathSolver& exact, std::istream* saved, RunContext& context);

}  // namespace geodrome::aleksandrov
