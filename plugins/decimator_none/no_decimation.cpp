// SPDX-License-Identifier: MIT
#include "plugins/decimator_none/no_decimation.hpp"

#include "plugins/common/points/live_points.hpp"

namespace geodrome {

std::vector<Index> NoDecimation::select(const PointSample& sample, const Control& control, RunContext& context) const {
  context.throw_if_cancelled();
  std::vector<Index> kept = live_points(sample, control.state).sample_index;
  context.progress(1);
  return kept;
}

}  // namespace geodrome
