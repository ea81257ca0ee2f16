// SPDX-License-Identifier: MIT
#include "engine/checks/pair_audit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/checks/rounding_scale.hpp"
#include "engine/search/distances.hpp"

namespace geodrome {

namespace {

constexpr std::size_t audited_pairs = 3;

/// Whether a search could tell the distance, and the factor is promised of it and of the oracle.
bool can_be_judged(const PreparedSolver& solver, const NamedPair& pair) {
  const Place &from = pair.from.place, &to = pair.to.place;
  return solver.takes_source_at(from) && solver.answers_at(to) && solver.states_factor_at(from) &&
         solver.states_factor_at(to);
}

std::vector<std::size_t> choose(const PreparedSolver& solver, std::span<const NamedPair> pairs,
                                std::span<const double> values) {
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const bool reached = pairs[i].from.place.state == Place::State::on_surface && std::isfinite(values[i]);
    if (reached && can_be_judged(solver, pairs[i])) usable.push_back(i);
  }
  if (usable.size() <= audited_pairs) return usable;
  return {usable.front(), usable[usable.size() / 2], usable.back()};
}

}  // namespace

PairAudit audit_pairs(const SurfaceMesh& mesh, const PreparedSolver& solver, std::span<const NamedPair> pairs,
                      std::span<const double> values, RunContext& context, bool bounded) {
  const double factor = solver.plugin.factor;
  PairAudit result;
  if (!std::isfinite(factor)) {
    result.not_audited = "the solver states no guarantee";
    return result;
  }
  const std::vector<std::size_t> chosen = choose(solver, pairs, values);
  result.pairs = chosen.size();
  if (chosen.empty()) result.not_audited = "no pair of which the solver promises a factor is reached";
  if (chosen.empty()) return result;
  const auto search = make_search(solver);
  RoundingScale scale;
  scale.points(mesh.positions());
  double worst = 0;
  for (const std::size_t i : chosen) {
    scale.distances({&values[i], 1});
    for (const NamedPair& pair : {pairs[i], NamedPair{pairs[i].to, pairs[i].from}}) {
      if (!can_be_judged(solver, pair)) continue;
      const double found = DistanceRule{bounded}(
          searched_distance(solver, *search, pair.from.place, pair.to.place, context), pair.from, pair.to);
      const double violation = std::max(values[i] - factor * found, found - factor * values[i]);
      if (violation > worst) worst = violation, result.worst_pair = i;
    }
  }
  if (scale.value() > 0) result.worst = worst / scale.value();
  return result;
}

std::vector<std::string> broken_promises(const PairAudit& audit, std::size_t pair) {
  if (audit.holds()) return {};
  return {"pair " + std::to_string(pair) + " and a search for it differ by more than the factor allows"};
}

}  // namespace geodrome
