// SPDX-License-Identifier: MIT
#include "plugins/tangent_pca/pca_tangents.hpp"

#include "geodrome/spatial_order.hpp"
#include "plugins/common/parallel_for.hpp"
#include "plugins/common/points/local_plane.hpp"

namespace geodrome {

Tangents PcaTangents::estimate(const PointSample& sample, RunContext& context) const {
  require_three_points(sample.size());
  const Neighbours neighbours(sample.points);
  const std::vector<Index> order = spatial_order(sample.points);
  Tangents tangents;
  tangents.plane.resize(sample.size());
  tangents.state.assign(sample.size(), PointState::ok);
  parallel_for(sample.size(), context, {}, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> around;
    for (std::size_t k = begin; k < end; ++k) {
      const Index i = order[k];
      const LocalPlane plane = grown_plane(neighbours, i, settings_.k, around);
      if (plane.collinear()) throw_collinear(i, sample.size());
      tangents.plane[i] = {sample.points[i], plane.normal, plane.residual};
    }
  });
  return tangents;
}

}  // namespace geodrome
