// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/checks/claims.hpp"
#include "engine/checks/stage_figures.hpp"

namespace geodrome {

/// The paper's guarantee is for epsilon up to this.
inline constexpr double epsilon_of_the_paper = 1.0 / 22;

/// The counts of input and sample stages.
struct SampleFacts {
  std::size_t rows = 0;       ///< of the file
  std::size_t merged = 0;     ///< rows at the place of an earlier one
  std::size_t nonfinite = 0;  ///< rows dropped because they are not finite
  std::size_t points = 0;     ///< pairwise distinct points, which the stages worked on
  std::size_t dropped = 0;    ///< points that a stage took for outliers
  std::size_t unbounded = 0, capped = 0, kept = 0;
  double sigma = 0, psi_smallest = 0, psi_largest = 0;  ///< NaN where no stage gave them

  std::size_t live() const { return points - dropped; }
};

SampleFacts facts_of(const Input& input, const SampleStages& stages);

/// The verdict on the paper's guarantee for a run on a sample. The guarantee is void when something it rests on fails;
/// nothing that is seen in a sample can confirm it, since epsilon refers to the unknown surface.
struct GuaranteeVerdict {
  std::vector<Claim> claims;
  std::vector<std::string> void_because;  ///< empty: nothing measured speaks against it
};

/// The estimated epsilon against 1/22, which the guarantee presupposes.
Claim claim_epsilon(const StageFigure& epsilon);

/// Weighs the claims of the paper and what it does not treat: capped, unbounded and dropped points, a boundary, a
/// solver that is not exact (`factor`: the solver's; none if none ran).
GuaranteeVerdict judge(std::vector<Claim> claims, const SampleFacts& facts, bool closed, std::optional<double> factor);

}  // namespace geodrome
