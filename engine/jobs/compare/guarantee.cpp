// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/guarantee.hpp"

#include <algorithm>
#include <cmath>

#include "engine/checks/rounding_scale.hpp"
#include "engine/formats/number_text.hpp"

namespace geodrome {

namespace {

/// The pair that is farthest beyond a bound.
struct Excess {
  double worst = -infinity;
  std::size_t source = 0, target = 0;
  std::uint64_t broken = 0;

  void add(double excess, double allowed, std::size_t i, std::size_t j) {
    broken += excess > allowed;
    if (excess > worst) worst = excess, source = i, target = j;
  }
};

std::string words(const Excess& excess, const DistanceRows& distances, const DistanceRows& truth, const char* what) {
  return std::to_string(excess.broken) + " distances are " + what + ": the worst from source " +
         std::to_string(excess.source) + " to row " + std::to_string(excess.target) + ", " +
         rounded_text(distances[excess.source][excess.target], 10) + " for " +
         rounded_text(truth[excess.source][excess.target], 10);
}

/// What there is to be judged; empty if something is.
std::string nothing_to_judge(const GuaranteeTerms& terms, std::uint64_t pairs) {
  if (!std::isfinite(terms.factor) && !terms.never_shorter) return "the solver states nothing";
  if (!terms.exact_truth) return "the truth is not the exact distance on this surface";
  if (pairs == 0) return "there is no pair that it is stated for";
  return {};
}

}  // namespace

double scale_of(const DistanceRows& distances, std::span<const Vec3> positions, double smallest_weight) {
  RoundingScale scale(smallest_weight);
  for (const auto& row : distances) scale.distances(row);
  return scale.points(positions).value();
}

GuaranteeFigures judge_guarantee(const DistanceRows& distances, const DistanceRows& truth,
                                 const GuaranteeTerms& terms) {
  GuaranteeFigures figures;
  const bool has_factor = std::isfinite(terms.factor);
  if (has_factor) figures.stated = terms.factor;
  Excess longer, shorter;
  std::uint64_t pairs = 0;
  const double allowed = terms.tolerance * terms.scale;
  for (std::size_t i = 0; i < distances.size(); ++i)
    for (std::size_t j = 0; terms.of_source[i] && j < distances[i].size(); ++j) {
      const double d = distances[i][j], t = truth[i][j];
      if (!terms.of_target[j] || !std::isfinite(d) || !std::isfinite(t)) continue;
      if (t > 0) ++pairs, figures.worst = std::max(figures.worst.value_or(0), d / t);
      if (has_factor) longer.add(d - terms.factor * t, allowed, i, j);
      if (terms.never_shorter) shorter.add(t - d, allowed, i, j);
    }
  figures.why = nothing_to_judge(terms, pairs);
  if (!figures.why.empty()) return figures;
  figures.held = longer.broken == 0 && shorter.broken == 0;
  if (longer.broken > 0) figures.why = words(longer, distances, truth, "above the factor");
  if (shorter.broken > 0)
    figures.why += (figures.why.empty() ? "" : "; ") + words(shorter, distances, truth, "below the true ones");
  if (*figures.held) {
    figures.why = has_factor ? "no distance is above the factor" : "";
    if (terms.never_shorter) figures.why += std::string(has_factor ? " or" : "no distance is") + " below the true one";
  }
  return figures;
}

}  // namespace geodrome
