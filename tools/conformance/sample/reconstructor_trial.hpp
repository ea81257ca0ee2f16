// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tools/conformance/sample/sample_trial.hpp"
#include "tools/shapes/small_meshes.hpp"

namespace geodrome::conformance {

/// What a reconstructor gets from stages 1 to 3.
struct Staged {
  PointSample sample;
  Tangents tangents;
  Control control;
  std::vector<Index> kept;
};

struct ReconstructorTrial : StageTrial<SurfaceReconstructor> {
  using StageTrial::StageTrial;

  /// As the plugins jet and lipschitz make it; every point that was not dropped is kept.
  Staged staged(const PointSample& sample) const {
    QuietContext context;
    Staged made{sample, {}, {}, {}};
    made.tangents = host.load<TangentEstimator>("jet").object->estimate(sample, context);
    for (std::size_t i = 0; i < sample.size(); ++i)
      if (made.tangents.state[i] != PointState::dropped) made.sample.points[i] = made.tangents.plane[i].origin;
    made.control = host.load<ControlFunction>("lipschitz").object->evaluate(made.sample, made.tangents, context);
    for (Index i = 0; i < sample.size(); ++i)
      if (made.control.state[i] != PointState::dropped) made.kept.push_back(i);
    return made;
  }

  Reconstruction reconstruct(const Staged& s) const {
    QuietContext context;
    return plugin.object->reconstruct(s.sample, s.tangents, s.control, s.kept, context);
  }
};

inline PointSample points_of(const MeshPtr& mesh) { return {{mesh->positions().begin(), mesh->positions().end()}}; }

}  // namespace geodrome::conformance
