// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/checks.hpp"

#include "engine/checks/matrix_view.hpp"
#include "engine/search/reach.hpp"
#include "engine/surface/face_weight.hpp"

namespace geodrome {

namespace {

Invariants invariants_of(const ComparedSurface& on, const PreparedSolver& solver, const DistanceRows& rows,
                         double change, std::uint64_t seed) {
  const auto read = [&](std::uint64_t row) { return rows[row]; };
  return check_invariants(on.sources, on.targets.named(), read,
                          {.factor = solver.plugin.factor,
                           .bounded = on.targets.bounded() || solver.provides(Provides::never_shorter),
                           .smallest_weight = smallest_weight(*on.surface->mesh),
                           .change = change,
                           .seed = seed});
}

InvariantCheck reach_of(const ComparedSurface& on, const DistanceRows& rows) {
  const SurfaceMesh& mesh = *on.surface->mesh;
  const std::vector<Index> of_source = components_of(mesh, on.sources),
                           of_target = components_of(mesh, on.targets.named());
  ReachCounts counts;
  for (std::size_t i = 0; i < rows.size(); ++i) count_reach(rows[i], of_source[i], of_target, false, counts);
  InvariantCheck check;
  check.violated = counts.missed + counts.impossible;
  check.tested = counts.reached + counts.unreachable + check.violated;
  return check;
}

/// For which of the queries the solver states its factor.
std::vector<bool> stated_for(std::span<const NamedPoint> queries, const PreparedSolver& solver) {
  std::vector<bool> stated;
  for (const NamedPoint& query : queries) stated.push_back(solver.states_factor_at(query.place));
  return stated;
}

}  // namespace

std::vector<NamedCheck> checks_of(const ComparedSurface& on, const Measurement& measured, const DistanceRows& rows,
                                  double change, std::uint64_t seed) {
  const Invariants invariants = invariants_of(on, measured.solver, rows, change, seed);
  const bool weighted = !on.surface->mesh->face_weights().empty();
  return {{"no NaN", invariants.computed},
          {"D(s,s)", invariants.identity},
          {weighted ? "D >= least weight x Euclid" : "D >= Euclid", invariants.euclid},
          {"symmetry", invariants.symmetry},
          {"triangle", invariants.triangle},
          {"reach", reach_of(on, rows)}};
}

GuaranteeFigures guarantee_of(const ComparedSurface& on, const Measurement& measured, const DistanceRows& true_rows,
                              const ComparisonTruth& truth) {
  GuaranteeTerms terms{.factor = measured.solver.plugin.factor,
                       .never_shorter = measured.solver.provides(Provides::never_shorter),
                       .exact_truth = truth.is_exact(),
                       .of_source = stated_for(on.sources, measured.solver),
                       .of_target = stated_for(on.targets.named(), measured.solver),
                       .tolerance = truth.tolerance()};
  terms.scale = scale_of(true_rows, on.surface->mesh->positions(), smallest_weight(*on.surface->mesh));
  return judge_guarantee(measured.rows, true_rows, terms);
}

}  // namespace geodrome
