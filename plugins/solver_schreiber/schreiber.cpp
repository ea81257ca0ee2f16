// SPDX-License-Identifier: MIT
#include "solver_schreiber/schreiber.hpp"

#include "common/solvers/exact_prepared.hpp"
#include "solver_schreiber/propagation.hpp"

namespace geodrome {

std::unique_ptr<PreparedSurface> SchreiberSolver::prepare(MeshPtr mesh, RunContext& context) const {
  return prepare_exact<schreiber::Propagation>(std::move(mesh), {}, context);
}

}  // namespace geodrome
