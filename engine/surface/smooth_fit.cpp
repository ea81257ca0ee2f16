// SPDX-License-Identifier: MIT
#include "engine/surface/smooth_fit.hpp"

#include <algorithm>
#include <tuple>

#include "engine/formats/remedies.hpp"
#include "engine/host/stage_context.hpp"

namespace geodrome {

namespace {

/// The places of a mesh's vertices, each once: samples have no two points at one place.
PointSample vertices_of(const SurfaceMesh& mesh) {
  PointSample sample{{mesh.positions().begin(), mesh.positions().end()}};
  std::ranges::sort(sample.points, {}, [](const Vec3& p) { return std::tuple(p.x, p.y, p.z); });
  const auto repeated = std::ranges::unique(sample.points);
  sample.points.erase(repeated.begin(), repeated.end());
  return sample;
}

/// A plugin may be anybody's: what breaks the interface must not travel on.
void demand_of_fit(bool holds, const PluginInfo& plugin, const char* what) {
  if (!holds) throw PluginError(std::string("gave ") + what, "report this to the author of " + plugin.file.string());
}

void measure(FittedSurface& fitted, std::size_t faces) {
  double sum = 0;
  for (Index f = 0; f < faces; ++f) {
    const double deviation = fitted.surface->deviation(f);
    demand_of_fit(deviation >= 0, fitted.record.plugin, "a deviation that is no number that is at least 0");
    if (!(deviation < infinity)) continue;
    ++fitted.trusted_faces, sum += deviation;
    fitted.largest_deviation = std::max(fitted.largest_deviation, deviation);
  }
  if (fitted.trusted_faces > 0) fitted.mean_deviation = sum / static_cast<double>(fitted.trusted_faces);
}

}  // namespace

Plugin<TangentEstimator> load_smooth_estimator(const PluginHost& host, const RunSettings& settings) {
  auto plugin = host.load<TangentEstimator>(settings.stages.tangent);
  if (!plugin.extension<SmoothFit>())
    throw CapabilityError(plugin.info.full_name() + " fits no smooth surface to measure on",
                          remedies::flat_metric_or_other_estimator());
  return plugin;
}

FittedSurface fit_smooth(const PlacedSurface& surface, const PointSample& sample, const PluginHost& host,
                         const RunSettings& settings, Observer& observer) {
  if (!surface.mesh->face_weights().empty())
    throw CapabilityError("smooth distances do not go with weights of faces", remedies::flat_metric());
  const auto plugin = load_smooth_estimator(host, settings);
  StageContext context("smooth", observer, thread_count(settings), settings.seed);
  const Stopwatch watch;
  FittedSurface fitted;
  plugin.call([&](const TangentEstimator& estimator) {
    const SmoothFit& table = *plugin.template extension<SmoothFit>();
    if (surface.sample) {
      fitted.surface = table.fit(estimator, {surface.mesh, sample, surface.sample->tangents}, context);
    } else {
      const PointSample vertices = vertices_of(*surface.mesh);
      const Tangents tangents = estimator.estimate(vertices, context);
      demand_of_fit(tangents.plane.size() == vertices.size() && tangents.state.size() == vertices.size(), plugin.info,
                    "not one tangent plane and state per point");
      fitted.surface = table.fit(estimator, {surface.mesh, vertices, tangents}, context);
    }
    demand_of_fit(fitted.surface != nullptr, plugin.info, "no surface");
    context.throw_if_cancelled();
    fitted.record = {plugin.info, plugin.options, watch.seconds(), context.measures()};
    measure(fitted, surface.mesh->face_count());
  });
  return fitted;
}

}  // namespace geodrome
