// SPDX-License-Identifier: MIT
#pragma once

#include "engine/jobs/compare/truth.hpp"

namespace geodrome {

/// The invariants of the rows, and that exactly the targets in a source's component are reached. `rows`: those of the
/// measurement, or what became of them: each is changed by `change` at most.
std::vector<NamedCheck> checks_of(const ComparedSurface& on, const Measurement& measured, const DistanceRows& rows,
                                  double change, std::uint64_t seed);

/// Holds what the solver states of its distances against the truth.
GuaranteeFigures guarantee_of(const ComparedSurface& on, const Measurement& measured, const DistanceRows& true_rows,
                              const ComparisonTruth& truth);

}  // namespace geodrome
