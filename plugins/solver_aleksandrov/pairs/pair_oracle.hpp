// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <memory>

#include "geodrome/shortest_path_solver.hpp"
#include "plugins/solver_aleksandrov/discretization.hpp"

namespace geodrome::aleksandrov {

/// Distances of arbitrary pairs within a factor of 1 + delta, or as read from `saved` if that is not null. Pairs that
/// the index does not settle are answered by a search no farther than its upper bound. The surface of `discretization`
/// outlives the oracle. Throws CapabilityError for face
/// weights; see PairIndex for the rest.
std::unique_ptr<PairOracle> make_pair_oracle(std::shared_ptr<const Discretization> discretization, double delta,
                                             std::istream* saved, RunContext& context);

}  // namespace geodrome::aleksandrov
