// SPDX-License-Identifier: MIT
#include "geodrome/plugin.hpp"
#include "geodrome/many_searches.hpp"
#include "plugins/solver_chen_han/chen_han.hpp"
#include "plugins/solver_chen_han/rows/prepare_rows.hpp"

namespace geodrome::chen_han {
namespace {

constexpr ManySearches many_searches{&prepare_rows};

}  // namespace
}  // namespace geodrome::chen_han

GEODROME_PLUGIN(geodrome::ChenHanSolver, .name = "chen_han",
                .summary = "exact, by windows (Chen and Han 1996, Xin and Wang 2009, Qin et al. 2016)",
                .licence = "MIT", .provides = geodrome::ChenHanSolver::provides,
                .options = geodrome::ChenHanSolver::options, .factor = geodrome::exact_factor,
                .extension = geodrome::extensions<geodrome::chen_han::many_searches>)
