// SPDX-License-Identifier: MIT
#include "plugins/solver_merged_windows/merged_windows.hpp"

#include <utility>

#include "plugins/common/exact/exact_prepared.hpp"
#include "plugins/solver_merged_windows/fallback.hpp"

namespace geodrome {

double MergedWindowsSolver::factor(const OptionValues* values) noexcept {
  return 1 + options.parsed(*values).delta;
}

std::unique_ptr<PreparedSurface> MergedWindowsSolver::prepare(MeshPtr mesh, RunContext& context) const {
  return prepare_exact<merged_windows::Fallback>(std::move(mesh), settings_, context);
}

}  // namespace geodrome
