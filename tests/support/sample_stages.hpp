// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/surface_reconstructor.hpp"
#include "plugins/control_lipschitz/lipschitz_control.hpp"
#include "plugins/decimator_greedy/greedy_decimation.hpp"
#include "plugins/tangent_pca/pca_tangents.hpp"

namespace geodrome::test {

/// What a reconstructor gets: stages 1 to 3 as the plugins do them.
struct Staged {
  PointSample sample;
  Tangents tangents;
  Control control;
  std::vector<Index> kept;
};

inline Staged staged(PointSample sample, bool decimate = true) {
  QuietContext context;
  Staged made{std::move(sample), {}, {}, {}};
  made.tangents = PcaTangents(OptionValues(pca_options, "k=20")).estimate(made.sample, context);
  made.control = LipschitzControl(OptionValues(lipschitz_options, "")).evaluate(made.sample, made.tangents, context);
  if (decimate)
    made.kept = GreedyDecimation().select(made.sample, made.control, context);
  else
    for (Index i = 0; i < made.sample.size(); ++i) made.kept.push_back(i);
  return made;
}

}  // namespace geodrome::test
