// SPDX-License-Identifier: MIT
#include "geodrome/plugin.hpp"
#include "plugins/solver_aleksandrov/aleksandrov.hpp"
#include "plugins/solver_chen_han/chen_han.hpp"

namespace geodrome {
namespace {

/// The solver with windows for the pairs that its index leaves open.
class AleksandrovPlugin final : public AleksandrovSolver {
 public:
  explicit AleksandrovPlugin(const OptionValues& options)
      : AleksandrovSolver(options, std::make_shared<ChenHanSolver>(OptionValues(ChenHanSolver::options))) {}
};

}  // namespace
}  // namespace geodrome

GEODROME_PLUGIN(geodrome::AleksandrovPlugin, .name = "aleksandrov",
                .summary = "within a factor of 1 + delta, by Steiner points (Aleksandrov, Maheshwari and Sack 2005)",
                .licence = "MIT", .provides = geodrome::AleksandrovSolver::provides,
                .options = geodrome::AleksandrovSolver::options, .factor = geodrome::AleksandrovSolver::factor)
