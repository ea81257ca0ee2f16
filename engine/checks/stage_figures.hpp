// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "geodrome/engine/pipeline.hpp"

namespace geodrome {

/// A figure that only a stage can measure.
struct StageFigure {
  double value = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not measured
  std::string by;  ///< the plugin that measured it, or that could have; empty if its stage did not run

  bool is_measured() const { return value == value; }
};

/// The figures that the sample report shows, by the names under which any plugin may measure them
/// (RunContext::measure):
///   inconsistent_stars  share (0 to 1) of the triangles of planar stars on which their corners disagree, outside of
///                       cocircular ties
///   star_ties           share (0 to 1) of the triangles that lie in cocircular ties
///   flips               labels that a repair of the surface changed
///   lids                faces left out by the boundary rule
///   rounds              rounds of repair
///   epsilon             estimate of the largest phi over local feature size
///   sigma               noise: standard deviation along the normal, units of the input
///   smoothed, outliers  points moved, points taken for outliers
/// The last stage that measured a name counts.
std::map<std::string, StageFigure> figures_of(const std::vector<StageRecord>& stages);

}  // namespace geodrome
