// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/many_searches.hpp"
#include "tests/plugins_for_tests/faulty/faulty_solver.hpp"

/// An exact solver without a fault, except on the surfaces that it makes for a plan of searches.
namespace geodrome::faulty {

/// Refers to another surface.
class SameSurface : public PreparedSurface {
 public:
  explicit SameSurface(const PreparedSurface& other) : other_(other) {}
  std::unique_ptr<Search> make_search() const override { return other_.make_search(); }
  std::size_t bytes() const override { return other_.bytes(); }

 private:
  const PreparedSurface& other_;
};

/// What `Fault` makes of a surface of a solver without a fault.
template <class Fault>
std::unique_ptr<PreparedSurface> planned_by(const PreparedSurface& prepared, const SearchPlan&, RunContext& context) {
  context.throw_if_cancelled();
  const MeshPtr& mesh = static_cast<const FaultySurface<NoFault>&>(prepared).mesh();
  return std::make_unique<FaultySurface<Fault>>(mesh, std::make_unique<SameSurface>(prepared));
}

}  // namespace geodrome::faulty

#define GEODROME_PLANNED_SOLVER(table, plugin_name)                                                                  \
  GEODROME_PLUGIN(geodrome::faulty::FaultySolver<geodrome::faulty::NoFault>, .name = plugin_name,                    \
                  .summary = "a faulty solver", .licence = "MIT", .provides = geodrome::test::ExactSolver::provides, \
                  .factor = geodrome::exact_factor, .extension = geodrome::extensions<table>)
