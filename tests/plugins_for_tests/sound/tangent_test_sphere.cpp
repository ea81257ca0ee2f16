// SPDX-License-Identifier: MIT
// Knows the surface that it is asked for, the unit sphere: what is made of an exact smooth surface can be seen.
#include "geodrome/plugin.hpp"
#include "tests/support/analytic_surfaces.hpp"

namespace geodrome::test {
namespace {

struct SphereSettings {
  double trusted;
};

constexpr auto sphere_options = settings_table(
    option("trusted", &SphereSettings::trusted, "2", -2, 2, "", "faces are trusted below this z, flat above"));

class SphereTangents : public TangentEstimator {
 public:
  explicit SphereTangents(const OptionValues& values) : settings_(sphere_options.parsed(values)) {}

  Tangents estimate(const PointSample& sample, RunContext&) const override {
    Tangents tangents;
    for (const Vec3& p : sample.points) tangents.plane.push_back({p, p / norm(p), 0});
    tangents.state.assign(sample.size(), PointState::ok);
    return tangents;
  }

  std::unique_ptr<SmoothSurface> fit(const SmoothTask& task) const {
    const auto deviation = [mesh = task.mesh, trusted = settings_.trusted](Index face) {
      const auto [p, q, r] = mesh->corners(face);
      return p.z + q.z + r.z < 3 * trusted ? 1e-9 : infinity;
    };
    return std::make_unique<AnalyticSurface<Ellipsoid>>(task.mesh, Ellipsoid{}, deviation);
  }

 private:
  SphereSettings settings_;
};

constexpr SmoothFit smooth_fit{[](const TangentEstimator& estimator, const SmoothTask& task, RunContext&) {
  return static_cast<const SphereTangents&>(estimator).fit(task);
}};

GEODROME_PLUGIN(SphereTangents, .name = "test_sphere", .summary = "tangent planes of the unit sphere", .licence = "MIT",
                .options = sphere_options, .extension = extensions<smooth_fit>)

}  // namespace
}  // namespace geodrome::test
