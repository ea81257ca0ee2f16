// SPDX-License-Identifier: MIT
// What every control function must do.
#include <optional>

#include "tools/conformance/sample/sample_trial.hpp"

namespace geodrome::conformance {
namespace {

struct Case {
  const char* name;
  PointSample sample;
  Tangents tangents;
};

struct ControlTrial : StageTrial<ControlFunction> {
  std::vector<Case> cases;

  explicit ControlTrial(const Subject& subject) : StageTrial(subject) {
    const Plugin<TangentEstimator> pca = host.load<TangentEstimator>("pca");
    for (auto& [name, sample] : usual_samples()) {
      SampleContext context;
      Tangents tangents = pca.object->estimate(sample, context);
      cases.push_back({name, std::move(sample), std::move(tangents)});
    }
  }
  Control evaluate(const Case& c, RunContext& context) const {
    return plugin.object->evaluate(c.sample, c.tangents, context);
  }
};

void one_for_each(ControlTrial& t) {
  for (const Case& c : t.cases) {
    SampleContext context;
    const Control control = t.evaluate(c, context);
    t.equal(control.phi.size(), c.sample.size(), c.name);
    t.equal(control.psi.size(), c.sample.size(), c.name);
    t.equal(control.state.size(), c.sample.size(), c.name);
    for (std::size_t i = 0; i < control.psi.size(); ++i) {
      t.holds(control.phi[i] > 0 && std::isfinite(control.phi[i]), "phi positive and finite", c.name, ", point ", i);
      t.holds(control.psi[i] > 0 && std::isfinite(control.psi[i]), "psi positive and finite", c.name, ", point ", i);
    }
    t.holds(context.progress_in_range, "progress between 0 and 1", c.name);
  }
}

void lipschitz(ControlTrial& t) {
  Random random(1);
  for (const Case& c : t.cases) {
    SampleContext context;
    const Control control = t.evaluate(c, context);
    for (int trial = 0; trial < 20000; ++trial) {
      const std::size_t i = random.below(c.sample.size()), j = random.below(c.sample.size());
      t.at_most(std::abs(control.psi[i] - control.psi[j]), distance(c.sample.points[i], c.sample.points[j]) / 18,
                c.name, ", points ", i, " and ", j);
    }
  }
}

/// Every fifth point is put elsewhere and dropped: the others must not notice.
void dropped_points(ControlTrial& t) {
  for (const Case& c : t.cases) {
    Case with = c, without{c.name, {}, {}};
    for (std::size_t i = 0; i < c.sample.size(); ++i) {
      if (i % 5 == 0) {
        with.tangents.state[i] = PointState::dropped;
        with.sample.points[i] = c.sample.points[i] + 0.1 * (c.sample.points[0] - c.sample.points[1]);
        continue;
      }
      without.sample.points.push_back(c.sample.points[i]);
      without.tangents.plane.push_back(c.tangents.plane[i]);
      without.tangents.state.push_back(c.tangents.state[i]);
    }
    SampleContext context;
    const Control all = t.evaluate(with, context), rest = t.evaluate(without, context);
    for (std::size_t i = 0, k = 0; i < c.sample.size(); ++i) {
      if (i % 5 == 0) {
        t.holds(std::isnan(all.phi[i]) && std::isnan(all.psi[i]), "NaN for a dropped point", c.name, ", point ", i);
        t.holds(all.state[i] == PointState::dropped, "the state dropped", c.name, ", point ", i);
        continue;
      }
      t.holds(all.phi[i] == rest.phi[k] && all.psi[i] == rest.psi[k] && all.state[i] == rest.state[k],
              "what it is without the dropped points", c.name, ", point ", i);
      ++k;
    }
  }
}

void threads(ControlTrial& t) {
  for (const Case& c : t.cases) {
    SampleContext one(1), four(4);
    const Control a = t.evaluate(c, one), b = t.evaluate(c, four);
    t.holds(a.phi == b.phi && a.psi == b.psi && a.state == b.state, "the same bits", c.name);
  }
}

void cancelled(ControlTrial& t) {
  SampleContext context;
  context.stop = true;
  t.throws<Cancelled>([&] { t.evaluate(t.cases.front(), context); });
}

}  // namespace

DemandTable control_demands() {
  return {
      demand<ControlTrial, one_for_each>("control.each_point", "each point gets a positive, finite phi and psi"),
      demand<ControlTrial, lipschitz>("control.lipschitz", "psi is 1/18-Lipschitz"),
      demand<ControlTrial, dropped_points>("control.dropped", "dropped points take part in nothing"),
      demand<ControlTrial, threads>("control.threads", "the number of threads changes no bit"),
      demand<ControlTrial, cancelled>("control.cancelled", "a cancelled run throws Cancelled"),
  };
}

}  // namespace geodrome::conformance
