// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/settings.hpp"
#include "geodrome/tangent_estimator.hpp"

namespace geodrome {

struct PcaSettings {
  std::size_t k;
};

inline constexpr auto pca_options =
    settings_table(option("k", &PcaSettings::k, "30", 2, 400, "points", "neighbours that the plane is fitted to"));

/// Tangent planes by principal components: the least-squares plane of a point and its k nearest neighbours.
///
/// The neighbourhood counts ties at the k-th distance in, so it does not depend on the order of the points. It grows,
/// doubling k, while it is too thin to show a plane (variance across below a tenth of that along). The plane goes
/// through the point itself; `residual` is measured from the fitted plane. `sigma` is 0: a plane cannot tell noise from
/// curvature. No point is dropped.
class PcaTangents final : public TangentEstimator {
 public:
  explicit PcaTangents(const OptionValues& options) : settings_(pca_options.parsed(options)) {}

  /// O(n (log n + k)). Throws SampleError for fewer than three points and for points on a line.
  Tangents estimate(const PointSample& sample, RunContext& context) const override;

 private:
  PcaSettings settings_;
};

}  // namespace geodrome
