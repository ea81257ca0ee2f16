// SPDX-License-Identifier: MIT
#include "plugins/common/points/live_points.hpp"

namespace geodrome {

LivePoints live_points(const PointSample& sample, std::span<const PointState> state) {
  LivePoints live;
  for (Index i = 0; i < sample.size(); ++i) {
    if (state[i] == PointState::dropped) continue;
    live.points.push_back(sample.points[i]);
    live.sample_index.push_back(i);
  }
  return live;
}

}  // namespace geodrome
