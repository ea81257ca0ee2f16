// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/surface_reconstructor.hpp"
#include "plugins/control_lipschitz/lipschitz_control.hpp"
#include "plugins/decimator_greedy/greedy_decimation.hpp"
#include "plugins/tangent_jet/jet_tangents.hpp"

namespace geodrome::test {

/// What a reconstructor gets: stages 1 to 3 as the plugins do them.
struct Staged {
  PointSample sample;
  Tangents tangents;
  Control control;
  std::vector<Index> kept;
};

/// Without decimation every point that was not dropped is kept.
inline Staged staged(const PointSample& sample, bool decimate = true) {
  QuietContext context;
  Staged made{sample, {}, {}, {}};
  made.tangents = JetTangents(OptionValues(jet_options, "")).estimate(sample, context);
  for (std::size_t i = 0; i < sample.size(); ++i)
    if (made.tangents.state[i] != PointState::dropped) made.sample.points[i] = made.tangents.plane[i].origin;
  made.control = LipschitzControl(OptionValues(lipschitz_options, "")).evaluate(made.sample, made.tangents, context);
  if (decimate) {
    made.kept = GreedyDecimation().select(made.sample, made.control, context);
    return made;
  }
  for (Index i = 0; i < sample.size(); ++i)
    if (made.control.state[i] != PointState::dropped) made.kept.push_back(i);
  return made;
}

}  // namespace geodrome::test
