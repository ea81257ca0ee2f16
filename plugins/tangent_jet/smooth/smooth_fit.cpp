// SPDX-License-Identifier: MIT
#include "plugins/tangent_jet/smooth/smooth_fit.hpp"

#include <utility>
#include <vector>

#include "plugins/common/parallel_for.hpp"
#include "plugins/tangent_jet/smooth/jet_surface.hpp"
#include "plugins/tangent_jet/smooth/trust.hpp"
#include "plugins/tangent_jet/smooth/vertex_jet.hpp"

namespace geodrome {

std::unique_ptr<SmoothSurface> fit_smooth_surface(const TangentEstimator&, const SmoothTask& task,
                                                  RunContext& context) {
  const JetPoints points(task.sample, task.tangents);
  const SurfaceMesh& mesh = *task.mesh;
  std::vector<QuarticFit> jets(mesh.vertex_count());
  parallel_for(points.raw.empty() ? 0 : jets.size(), context, {}, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> around;
    for (std::size_t v = begin; v < end; ++v) jets[v] = vertex_jet(points, mesh.positions()[v], around);
  });
  std::vector<double> deviations = face_deviations(mesh, jets, points.sigma);
  std::vector<Quartic> quartics;
  quartics.reserve(jets.size());
  for (const QuarticFit& jet : jets) quartics.push_back(jet.quartic);
  return std::make_unique<JetSurface>(task.mesh, std::move(quartics), std::move(deviations));
}

}  // namespace geodrome
