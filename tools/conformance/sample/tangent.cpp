// SPDX-License-Identifier: MIT
// What every tangent estimator must do.
#include "tools/conformance/sample/sample_trial.hpp"

namespace geodrome::conformance {
namespace {

using TangentTrial = StageTrial<TangentEstimator>;

void one_for_each(TangentTrial& t) {
  for (const auto& [name, sample] : usual_samples()) {
    SampleContext context;
    const Tangents tangents = t.plugin.object->estimate(sample, context);
    t.equal(tangents.plane.size(), sample.size(), name);
    t.equal(tangents.state.size(), sample.size(), name);
    for (std::size_t i = 0; i < tangents.plane.size(); ++i) {
      const TangentPlane& plane = tangents.plane[i];
      t.near(norm(plane.normal), 1, 1e-12, "length of a normal, ", name, ", point ", i);
      t.holds(is_finite(plane.origin), "a finite origin", name, ", point ", i);
      t.at_least(plane.residual, 0, "residual, ", name, ", point ", i);
    }
    t.at_least(tangents.sigma, 0, "sigma, ", name);
    t.holds(context.progress_in_range, "progress between 0 and 1", name);
  }
}

void right_on_a_torus(TangentTrial& t) {
  const PointSample sample = torus(10000, 7);
  SampleContext context;
  const Tangents tangents = t.plugin.object->estimate(sample, context);
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const Vec3& p = sample.points[i];
    const double ring = std::hypot(p.x, p.y);
    const Vec3 normal = Vec3{p.x - p.x / ring, p.y - p.y / ring, p.z} / 0.4;
    t.at_most(norm(cross(tangents.plane[i].normal, normal)), 0.2, "sine of the error, point ", i);
  }
}

void threads(TangentTrial& t) {
  for (const auto& [name, sample] : usual_samples()) {
    SampleContext one(1), four(4);
    const Tangents a = t.plugin.object->estimate(sample, one), b = t.plugin.object->estimate(sample, four);
    t.holds(a.state == b.state && a.sigma == b.sigma, "the same states and sigma", name);
    for (std::size_t i = 0; i < sample.size(); ++i)
      t.holds(a.plane[i].normal == b.plane[i].normal && a.plane[i].origin == b.plane[i].origin &&
                  a.plane[i].residual == b.plane[i].residual,
              "the same plane", name, ", point ", i);
  }
}

void no_plane(TangentTrial& t) {
  const PointSample refused[] = {{}, {{{0, 0, 0}, {1, 0, 0}}}, {{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}}};
  for (const PointSample& sample : refused) {
    SampleContext context;
    t.throws<SampleError>([&] { t.plugin.object->estimate(sample, context); }, sample.size(), " points");
  }
}

void cancelled(TangentTrial& t) {
  SampleContext context;
  context.stop = true;
  t.throws<Cancelled>([&] { t.plugin.object->estimate(torus(5000, 1), context); });
}

}  // namespace

DemandTable tangent_demands() {
  return {
      demand<TangentTrial, one_for_each>("tangents.each_point",
                                         "each point gets a plane with a unit normal, and a state"),
      demand<TangentTrial, right_on_a_torus>("tangents.torus", "no normal of a dense torus is off by 11 degrees"),
      demand<TangentTrial, threads>("tangents.threads", "the number of threads changes no bit"),
      demand<TangentTrial, no_plane>("tangents.no_plane", "a sample that spans no plane is refused"),
      demand<TangentTrial, cancelled>("tangents.cancelled", "a cancelled run throws Cancelled"),
  };
}

}  // namespace geodrome::conformance
