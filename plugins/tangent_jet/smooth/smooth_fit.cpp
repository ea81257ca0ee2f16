// SPDX-License-Identifier: MIT
#include "plugins/tangent_jet/smooth/smooth_fit.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "plugins/common/parallel_for.hpp"
#include "plugins/tangent_jet/smooth/fit_size.hpp"
#include "plugins/tangent_jet/smooth/jet_surface.hpp"
#include "plugins/tangent_jet/smooth/trust.hpp"
#include "plugins/tangent_jet/smooth/vertex_jet.hpp"

namespace geodrome {
namespace {

/// How far the points of a quartic should reach, in halves of the longest edge of its vertex: so far does the blend use
/// it. Farther, and the quartics of uniform samples lose; nearer, and those where dense and sparse points meet.
constexpr double reach_share = 1.5;

std::vector<double> reaches(const SurfaceMesh& mesh) {
  std::vector<double> reach(mesh.vertex_count(), 0);
  for (Index h = 0; h < 3 * mesh.face_count(); ++h) {
    const Index from = mesh.from(h), to = mesh.to(h);
    const double wanted = reach_share / 2 * distance(mesh.positions()[from], mesh.positions()[to]);
    reach[from] = std::max(reach[from], wanted), reach[to] = std::max(reach[to], wanted);
  }
  return reach;
}

}  // namespace

std::unique_ptr<SmoothSurface> fit_smooth_surface(const TangentEstimator&, const SmoothTask& task,
                                                  RunContext& context) {
  const JetPoints points(task.sample, task.tangents);
  const SurfaceMesh& mesh = *task.mesh;
  const std::vector<double> reach = reaches(mesh);
  const FitSize noisy = points.sigma > 0 ? best_fit_size(points, mesh.positions(), context) : FitSize{};
  std::vector<QuarticFit> jets(mesh.vertex_count());
  parallel_for(points.raw.empty() ? 0 : jets.size(), context, {}, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> around;
    for (std::size_t v = begin; v < end; ++v)
      jets[v] = vertex_jet(points, mesh.positions()[v], reach[v], noisy, around);
  });
  std::vector<double> deviations = face_deviations(mesh, jets, {points.sigma, noisy.left_out});
  std::vector<Quartic> quartics;
  quartics.reserve(jets.size());
  for (const QuarticFit& jet : jets) quartics.push_back(jet.quartic);
  return std::make_unique<JetSurface>(task.mesh, std::move(quartics), std::move(deviations));
}

}  // namespace geodrome
