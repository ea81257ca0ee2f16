// SPDX-License-Identifier: MIT
// Searches that are prepared together know the first of several sources alone, as the plan has searches of one.
#include "tests/plugins_for_tests/faulty/planned_solver.hpp"

namespace {
struct FirstAlone : geodrome::faulty::NoFault {
  static void sources(std::vector<geodrome::Source>& sources) { sources.resize(1); }
};
constexpr geodrome::ManySearches planned{geodrome::faulty::planned_by<FirstAlone>};
}  // namespace

GEODROME_PLANNED_SOLVER(planned, "faulty_planned_sources")
