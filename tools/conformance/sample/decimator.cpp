// SPDX-License-Identifier: MIT
// What every decimator must do.
#include <algorithm>
#include <limits>

#include "tools/conformance/sample/sample_trial.hpp"

namespace geodrome::conformance {
namespace {

using DecimatorTrial = StageTrial<Decimator>;

/// psi = 0.1 + |x| / 20: 1/20-Lipschitz; every seventh point is dropped.
Control control_of(const PointSample& sample) {
  Control control;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const bool dropped = i % 7 == 3;
    const double psi = dropped ? std::numeric_limits<double>::quiet_NaN() : 0.1 + std::abs(sample.points[i].x) / 20;
    control.psi.push_back(psi);
    control.phi.push_back(psi);
    control.state.push_back(dropped ? PointState::dropped : PointState::ok);
  }
  return control;
}

std::vector<NamedSample> samples() {
  return {{"torus", torus(3000, 1, 10)},
          {"ellipsoid", ellipsoid(2000, 2)},
          {"plane", plane(1000, 3)},
          {"plane grid", plane_lattice(20, 20)}};
}

void ascending(DecimatorTrial& t) {
  for (const auto& [name, sample] : samples()) {
    const Control control = control_of(sample);
    SampleContext context;
    const std::vector<Index> kept = t.plugin.object->select(sample, control, context);
    t.holds(!kept.empty(), "some points are kept", name);
    t.holds(std::adjacent_find(kept.begin(), kept.end(), std::greater_equal<>()) == kept.end(), "ascending", name);
    for (const Index i : kept) {
      t.holds(i < sample.size(), "an index of the sample", name, ", index ", i);
      t.holds(i >= sample.size() || control.state[i] != PointState::dropped, "no dropped point", name, ", index ", i);
    }
    t.holds(context.progress_in_range, "progress between 0 and 1", name);
  }
}

void covering(DecimatorTrial& t) {
  for (const auto& [name, sample] : samples()) {
    const Control control = control_of(sample);
    SampleContext context;
    const std::vector<Index> kept = t.plugin.object->select(sample, control, context);
    for (std::size_t i = 0; i < sample.size(); ++i) {
      if (control.state[i] == PointState::dropped) continue;
      const bool covered = std::any_of(kept.begin(), kept.end(), [&, &sample = sample](Index s) {
        return distance(sample.points[i], sample.points[s]) <= control.psi[s];
      });
      t.holds(covered, "a kept point that has this one within its psi", name, ", point ", i);
    }
  }
}

void threads(DecimatorTrial& t) {
  for (const auto& [name, sample] : samples()) {
    SampleContext one(1, 5), four(4, 5);
    const Control control = control_of(sample);
    t.holds(t.plugin.object->select(sample, control, one) == t.plugin.object->select(sample, control, four),
            "the same points", name);
  }
}

void all_dropped(DecimatorTrial& t) {
  const PointSample sample = torus(100, 1);
  const std::vector<double> none(100, std::numeric_limits<double>::quiet_NaN());
  SampleContext context;
  const Control control{none, none, std::vector(100, PointState::dropped)};
  t.equal(t.plugin.object->select(sample, control, context).size(), 0u, "points kept");
}

void cancelled(DecimatorTrial& t) {
  const PointSample sample = torus(5000, 1);
  SampleContext context;
  context.stop = true;
  t.throws<Cancelled>([&] { t.plugin.object->select(sample, control_of(sample), context); });
}

}  // namespace

DemandTable decimator_demands() {
  return {
      demand<DecimatorTrial, ascending>("decimator.ascending",
                                        "kept are ascending indices of points that are not dropped"),
      demand<DecimatorTrial, covering>("decimator.covering", "every point has a kept one within that one's psi"),
      demand<DecimatorTrial, threads>("decimator.threads", "the number of threads changes nothing"),
      demand<DecimatorTrial, all_dropped>("decimator.all_dropped", "nothing is kept where all is dropped"),
      demand<DecimatorTrial, cancelled>("decimator.cancelled", "a cancelled run throws Cancelled"),
  };
}

}  // namespace geodrome::conformance
