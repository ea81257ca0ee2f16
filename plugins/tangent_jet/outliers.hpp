// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "plugins/tangent_jet/local_jet.hpp"

namespace geodrome {

enum class OutlierRule {
  local,     ///< off the tangent planes of its neighbours, or in a sparse crowd that is no surface
  distance,  ///< farther from its 8th neighbour than three times the median of all points
  off
};

/// Which points are outliers: one round, after which the jets of the others should be renewed.
///
/// `local` takes a point for an outlier if it is high above the tangent planes of its 8 nearest neighbours, which
/// themselves agree with theirs; the second lowest of the eight counts, since at a sharp edge some planes do pass.
/// High is: steeper than 0.4 to the plane, four times as high as its neighbours are, and more than five sigma. Or if
/// its 8th neighbour is farther than three medians and its neighbourhood fills space (a sparse part of a surface is
/// flat) or is dense three times as near (density changes gradually on a surface). `sigma`: the noise, 0 if there is
/// none. None if there are 20 points or fewer. O(n).
std::vector<bool> find_outliers(const std::vector<Vec3>& points, const std::vector<LocalJet>& jets, double sigma,
                                OutlierRule rule);

}  // namespace geodrome
