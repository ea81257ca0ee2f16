// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/settings.hpp"
#include "geodrome/tangent_estimator.hpp"
#include "plugins/tangent_jet/outliers.hpp"

namespace geodrome {

/// Whether points are moved onto the surface.
enum class Smooth { where_noisy, always, never };

struct JetSettings {
  std::size_t k;
  Smooth smooth;
  OutlierRule outliers;
};

inline constexpr auto jet_options = settings_table(
    option("k", &JetSettings::k, "20", 6, 400, "points", "neighbours that the quadric is fitted to"),
    option("smooth", &JetSettings::smooth, "auto", "auto|on|off", {Smooth::where_noisy, Smooth::always, Smooth::never},
           "move points onto the surface: where there is noise, always, never"),
    option("outliers", &JetSettings::outliers, "auto", "auto|distance|off",
           {OutlierRule::local, OutlierRule::distance, OutlierRule::off},
           "drop outliers: by the planes around them, by distance from the 8th neighbour alone, none"));

/// Tangent planes by 2-jets (Cazals and Pouget, *Estimating differential quantities using polynomial fitting of
/// osculating jets*, 2005): a quadric is fitted over the least-squares plane of a point and its k nearest neighbours;
/// its normal above the point is the normal.
///
/// Before that outliers are dropped (outliers.hpp), and if noise is significant (noise.hpp) the points are moved onto a
/// smoothed surface (smoothing.hpp) and get its normals. Neighbourhoods count ties at the last place in, so nothing
/// depends on the order of the points. `sigma` is the noise if it is significant, also with smooth=off; with smooth=on
/// the upper bound that the residuals give. Measures: "sigma", "spacing", "smoothed" (points moved), "restored" (put
/// back for being at one place), "smoothing_neighbours", "outliers", "grown_neighbourhoods".
class JetTangents final : public TangentEstimator {
 public:
  explicit JetTangents(const OptionValues& options) : settings_(jet_options.parsed(options)) {}

  /// O(n (log n + k)). Throws SampleError for fewer than three points and for points on a line.
  Tangents estimate(const PointSample& sample, RunContext& context) const override;

 private:
  JetSettings settings_;
};

}  // namespace geodrome
