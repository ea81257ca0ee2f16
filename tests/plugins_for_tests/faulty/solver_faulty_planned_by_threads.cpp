// SPDX-License-Identifier: MIT
// Whether it prepares searches together depends on the number of threads.
#include "tests/plugins_for_tests/faulty/planned_solver.hpp"

namespace {
using namespace geodrome;

constexpr ManySearches planned{[](const PreparedSurface& prepared, const SearchPlan& plan,
                                  RunContext& context) -> std::unique_ptr<PreparedSurface> {
  if (context.threads() > 1) return nullptr;
  return faulty::planned_by<faulty::NoFault>(prepared, plan, context);
}};
}  // namespace

GEODROME_PLANNED_SOLVER(planned, "faulty_planned_by_threads")
