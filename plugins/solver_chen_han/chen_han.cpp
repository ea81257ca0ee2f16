// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/chen_han.hpp"

#include <string>
#include <utility>

#include "plugins/common/exact/exact_prepared.hpp"
#include "plugins/solver_chen_han/lanes.hpp"
#include "plugins/solver_chen_han/propagation.hpp"

namespace geodrome {
namespace {

chen_han::Simd simd_level(const std::string& name) {
  using chen_han::Simd;
  if (name == "auto") return chen_han::best_simd();
  const Simd level = name == "avx512" ? Simd::avx512 : name == "avx2" ? Simd::avx2 : Simd::baseline;
  if (!chen_han::has_simd(level))
    throw OptionError("this processor does not have " + name, "leave simd to auto: the results are the same");
  return level;
}

}  // namespace

ChenHanSolver::ChenHanSolver(const Choices& choices)
    : settings_{.filter = choices.filter,
                .simd = simd_level(choices.simd),
                .rows = choices.rows,
                .most_list_bytes = std::size_t{choices.lists_memory} << 20} {}

std::unique_ptr<PreparedSurface> ChenHanSolver::prepare(MeshPtr mesh, RunContext& context) const {
  return prepare_exact<chen_han::Propagation>(std::move(mesh), settings_, context);
}

}  // namespace geodrome
