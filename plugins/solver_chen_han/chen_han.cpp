// SPDX-License-Identifier: MIT
#include "solver_chen_han/chen_han.hpp"

#include <string>
#include <utility>

#include "common/solvers/flat_surface.hpp"
#include "solver_chen_han/lanes.hpp"
#include "solver_chen_han/search.hpp"

namespace geodrome {
namespace {

chen_han::Simd simd_level(const std::string& name) {
  using chen_han::Simd;
  if (name == "auto") return chen_han::best_simd();
  const Simd level = name == "avx2" ? Simd::avx2 : Simd::baseline;
  if (!chen_han::has_simd(level))
    throw OptionError("this processor does not have " + name, "leave simd to auto: the results are the same");
  return level;
}

class ChenHanPrepared final : public PreparedSurface {
 public:
  ChenHanPrepared(MeshPtr mesh, const chen_han::Settings& settings)
      : surface_(std::make_shared<const FlatSurface>(std::move(mesh))), settings_(settings) {}
  std::unique_ptr<Search> make_search() const override {
    return std::make_unique<chen_han::WindowSearch>(surface_, settings_);
  }
  std::size_t bytes() const override { return surface_->bytes(); }

 private:
  std::shared_ptr<const FlatSurface> surface_;
  chen_han::Settings settings_;
};

}  // namespace

ChenHanSolver::ChenHanSolver(const OptionValues& options)
    : settings_{options.text("filter") == "xin_wang", simd_level(options.text("simd"))} {}

std::unique_ptr<PreparedSurface> ChenHanSolver::prepare(MeshPtr mesh, RunContext& context) const {
  context.throw_if_cancelled();
  if (!mesh->face_weights().empty())
    throw CapabilityError("face weights are not supported", "choose a solver that provides weights");
  return std::make_unique<ChenHanPrepared>(std::move(mesh), settings_);
}

}  // namespace geodrome
