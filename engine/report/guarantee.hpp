// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "engine/report/surface_facts.hpp"
#include "geodrome/engine/pipeline.hpp"

namespace geodrome {

/// One bound that the paper proves for epsilon <= 1/22, and what was measured.
struct Claim {
  std::string name, source;  ///< "smallest angle >= pi/20", "Lemma 15"
  double measured = 0, bound = 0;
  bool holds = false;
};

/// What can be said of the paper's guarantee for a run on a sample. It is void when something it rests on fails;
/// nothing that is seen in a sample can confirm it, since epsilon refers to the unknown surface.
struct GuaranteeVerdict {
  std::vector<Claim> claims;
  std::vector<std::string> void_because;  ///< empty: nothing measured speaks against it
};

/// The counts of the sample stages, for the report.
struct SampleFacts {
  std::size_t points = 0, kept = 0, unbounded = 0, capped = 0, dropped = 0;
  double sigma = 0, psi_smallest = 0, psi_largest = 0;
};

SampleFacts facts_of(const SampleStages& stages);

/// Measures the paper's constants on a surface made from points. Lipschitz pairs are the surface's edges and 10,000
/// seeded random pairs. `factor` is the solver's. O(n log n).
GuaranteeVerdict judge(const Surface& surface, const SurfaceFacts& facts, double factor, std::uint64_t seed);

}  // namespace geodrome
