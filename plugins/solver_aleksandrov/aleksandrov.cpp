// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/aleksandrov.hpp"

#include <algorithm>
#include <utility>

#include "plugins/common/exact/propagation_search.hpp"
#include "plugins/solver_aleksandrov/pairs/pair_oracle.hpp"
#include "plugins/solver_aleksandrov/propagation.hpp"

namespace geodrome {
namespace {

class AleksandrovPrepared final : public PreparedSurface {
 public:
  AleksandrovPrepared(MeshPtr mesh, const aleksandrov::Settings& settings,
                      std::shared_ptr<const ShortestPathSolver> exact, RunContext& context)
      : delta_(settings.delta),
        exact_(std::move(exact)),
        surface_(std::make_shared<const PackedMesh>(std::move(mesh))),
        discretization_(std::make_shared<const aleksandrov::Discretization>(*surface_, settings, context)) {}

  std::unique_ptr<Search> make_search() const override {
    return std::make_unique<PropagationSearch<aleksandrov::Propagation>>(surface_, discretization_);
  }
  std::unique_ptr<PairOracle> pair_oracle(std::istream* saved, RunContext& context) const override {
    return aleksandrov::make_pair_oracle(discretization_, delta_, *exact_, saved, context);
  }
  std::size_t bytes() const override { return surface_->bytes() + discretization_->bytes(); }

 private:
  double delta_;
  std::shared_ptr<const ShortestPathSolver> exact_;
  std::shared_ptr<const PackedMesh> surface_;
  std::shared_ptr<const aleksandrov::Discretization> discretization_;
};

}  // namespace

AleksandrovSolver::AleksandrovSolver(const OptionValues& values, std::shared_ptr<const ShortestPathSolver> exact)
    : settings_(options.parsed(values)), exact_(std::move(exact)) {}

double AleksandrovSolver::factor(const OptionValues* values) noexcept {
  const Settings settings = options.parsed(*values);
  return settings.thinning == 1 ? 1 + settings.delta : infinity;
}

std::unique_ptr<PreparedSurface> AleksandrovSolver::prepare(MeshPtr mesh, RunContext& context) const {
  context.throw_if_cancelled();
  const auto positions = mesh->positions();
  if (mesh->face_count() > 0 && std::ranges::all_of(positions, [&](const Vec3& p) { return p == positions[0]; }))
    throw InputError(InputFault::degenerate, "all vertices of the surface are at one place",
                     "choose an exact solver: nothing here tells how long rounding is");
  return std::make_unique<AleksandrovPrepared>(std::move(mesh), settings_, exact_, context);
}

}  // namespace geodrome
