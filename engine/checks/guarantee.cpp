// SPDX-License-Identifier: MIT
#include "engine/checks/guarantee.hpp"

#include <algorithm>

namespace geodrome {

namespace {

/// "1 point has", "2 points have".
std::string points_have(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " point has" : " points have");
}
std::string points_were(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " point was" : " points were");
}

}  // namespace

SampleFacts facts_of(const Input& input, const SampleStages& stages) {
  constexpr double not_computed = std::numeric_limits<double>::quiet_NaN();
  SampleFacts facts;
  facts.rows = input.facts.rows, facts.merged = input.facts.merged, facts.nonfinite = input.facts.dropped;
  facts.points = input.positions.size(), facts.kept = stages.kept.size();
  facts.sigma = stages.tangents.state.empty() ? not_computed : stages.tangents.sigma;
  // The states of stage 2 include those of stage 1.
  const auto& states = stages.control.state.empty() ? stages.tangents.state : stages.control.state;
  for (const PointState state : states) {
    facts.unbounded += state == PointState::unbounded;
    facts.capped += state == PointState::capped;
    facts.dropped += state == PointState::dropped;
  }
  facts.psi_smallest = facts.psi_largest = not_computed;
  for (const double psi : stages.control.psi) {
    facts.psi_smallest = std::fmin(facts.psi_smallest, psi);  // fmin and fmax pass over NaN
    facts.psi_largest = std::fmax(facts.psi_largest, psi);
  }
  return facts;
}

Claim claim_epsilon(const StageFigure& epsilon) {
  Claim claim;
  claim.code = "epsilon", claim.name = "estimated epsilon <= 1/22", claim.source = "the paper's premise";
  claim.bound = epsilon_of_the_paper, claim.measured = epsilon.value;
  if (!epsilon.is_measured())
    claim.not_measured = epsilon.by.empty() ? "its stage did not run" : "not measured by " + epsilon.by;
  return claim;
}

GuaranteeVerdict judge(std::vector<Claim> claims, const SampleFacts& facts, bool closed, std::optional<double> factor) {
  GuaranteeVerdict verdict;
  const auto blame = [&](bool fails, std::string why) {
    if (fails) verdict.void_because.push_back(std::move(why));
  };
  for (const Claim& claim : claims) blame(claim.fails(), claim.name + " (" + claim.source + ") fails");
  blame(facts.capped > 0, points_have(facts.capped) + " a capped phi, which Theorem 3 does not cover");
  blame(facts.unbounded > 0,
        points_have(facts.unbounded) + " an unbounded planar cell: a boundary, which the paper does not treat");
  blame(facts.dropped > 0, points_were(facts.dropped) + " dropped");
  blame(!closed, "the surface has a boundary, which the paper does not treat");
  blame(factor && *factor != 1, "the solver is not exact");
  verdict.claims = std::move(claims);
  return verdict;
}

}  // namespace geodrome
