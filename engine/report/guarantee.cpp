// SPDX-License-Identifier: MIT
#include "engine/report/guarantee.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace geodrome {

namespace {

constexpr std::size_t random_pairs = 10'000;

/// Largest |psi(s) - psi(s')| / |s s'|.
double lipschitz_constant(const Surface& surface, std::uint64_t seed) {
  const std::vector<double>& psi = surface.sample->control.psi;
  const std::vector<Vec3>& points = surface.sample->smoothed.points;
  double worst = 0;
  const auto add = [&](std::size_t i, std::size_t j) {
    if (i == j || std::isnan(psi[i]) || std::isnan(psi[j])) return;
    worst = std::max(worst, std::abs(psi[i] - psi[j]) / distance(points[i], points[j]));
  };
  const auto& sample_of = surface.sample->sample_of_vertex;
  for (const Triangle& t : surface.mesh->triangles())
    for (int i = 0; i < 3; ++i) {
      const Index a = sample_of[t[i]], b = sample_of[t[(i + 1) % 3]];
      if (a != no_index && b != no_index) add(a, b);
    }
  std::mt19937_64 random(seed);
  for (std::size_t k = 0; k < random_pairs; ++k) {
    const std::size_t i = random() % psi.size();
    add(i, random() % psi.size());
  }
  return worst;
}

/// Largest |s s'| / min(psi(s), psi(s')) over the surface's edges (Lemma 9).
double edge_to_psi(const Surface& surface) {
  const std::vector<double>& psi = surface.sample->control.psi;
  const std::vector<Vec3>& points = surface.sample->smoothed.points;
  const auto& sample_of = surface.sample->sample_of_vertex;
  double worst = 0;
  for (const Triangle& t : surface.mesh->triangles())
    for (int i = 0; i < 3; ++i) {
      const Index a = sample_of[t[i]], b = sample_of[t[(i + 1) % 3]];
      if (a == no_index || b == no_index) continue;
      worst = std::max(worst, distance(points[a], points[b]) / std::min(psi[a], psi[b]));
    }
  return worst;
}

Claim at_most(std::string name, std::string source, double measured, double bound) {
  return {std::move(name), std::move(source), measured, bound, measured <= bound};
}
Claim at_least(std::string name, std::string source, double measured, double bound) {
  return {std::move(name), std::move(source), measured, bound, measured >= bound};
}

/// Lemma 6 as the decimator itself measured it, where it did.
void add_lemma_6(const Surface& surface, std::vector<Claim>& claims) {
  for (const StageRecord& stage : surface.stages) {
    const auto found = stage.measures.find("lemma_6_worst_ratio");
    if (found != stage.measures.end())
      claims.push_back(at_least("distance of kept points over psi >= 17/18", "Lemma 6", found->second, 17.0 / 18));
  }
}

}  // namespace

SampleFacts facts_of(const SampleStages& stages) {
  SampleFacts facts;
  facts.points = stages.control.psi.size(), facts.kept = stages.kept.size(), facts.sigma = stages.tangents.sigma;
  for (const PointState state : stages.control.state) {
    facts.unbounded += state == PointState::unbounded;
    facts.capped += state == PointState::capped;
    facts.dropped += state == PointState::dropped;
  }
  facts.psi_smallest = std::numeric_limits<double>::infinity();
  for (const double psi : stages.control.psi) {
    if (std::isnan(psi)) continue;
    facts.psi_smallest = std::min(facts.psi_smallest, psi);
    facts.psi_largest = std::max(facts.psi_largest, psi);
  }
  return facts;
}

GuaranteeVerdict judge(const Surface& surface, const SurfaceFacts& facts, double factor, std::uint64_t seed) {
  GuaranteeVerdict verdict;
  std::vector<Claim>& claims = verdict.claims;
  claims.push_back(at_most("psi is 1/18-Lipschitz", "Lemma 5", lipschitz_constant(surface, seed), 1.0 / 18));
  add_lemma_6(surface, claims);
  claims.push_back(at_most("edge length over psi <= 4.112", "Lemma 9", edge_to_psi(surface), 4.112));
  claims.push_back(at_most("degree <= 3925", "Lemma 12", static_cast<double>(facts.largest_degree), 3925));
  claims.push_back(at_most("edge ratio of a face <= 6", "Lemma 14", facts.largest_edge_ratio, 6));
  claims.push_back(at_least("smallest angle >= pi/20", "Lemma 15", facts.smallest_angle, std::numbers::pi / 20));
  for (const Claim& claim : claims)
    if (!claim.holds) verdict.void_because.push_back(claim.name + " (" + claim.source + ") fails");

  const SampleFacts sample = facts_of(*surface.sample);
  const auto blame = [&](bool fails, std::string why) {
    if (fails) verdict.void_because.push_back(std::move(why));
  };
  blame(sample.capped > 0, std::to_string(sample.capped) + " points have a capped phi, which Theorem 3 does not cover");
  blame(sample.unbounded > 0, std::to_string(sample.unbounded) +
                                  " points have an unbounded planar cell: a boundary, which the paper does not treat");
  blame(sample.dropped > 0, std::to_string(sample.dropped) + " points were dropped");
  blame(!facts.closed, "the surface has a boundary, which the paper does not treat");
  blame(factor != 1, "the solver is not exact");
  return verdict;
}

}  // namespace geodrome
