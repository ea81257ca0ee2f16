// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/schreiber.hpp"

#include "plugins/common/exact/exact_prepared.hpp"
#include "plugins/solver_schreiber/propagation.hpp"

namespace geodrome {

std::unique_ptr<PreparedSurface> SchreiberSolver::prepare(MeshPtr mesh, RunContext& context) const {
  return prepare_exact<schreiber::Propagation>(std::move(mesh), {}, context);
}

}  // namespace geodrome
