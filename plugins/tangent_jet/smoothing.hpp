// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "geodrome/tangent_estimator.hpp"
#include "plugins/common/parallel_for.hpp"
#include "plugins/common/points/neighbours.hpp"

namespace geodrome {

/// The points moved onto the surface that two moving-least-squares projections give (Alexa et al., *Computing and
/// rendering point set surfaces*, 2003; here the height is the quadric's): a quadric is fitted to the `k` nearest
/// points of the sample, the point goes to it along the plane's normal, and again from there, over the quadric's
/// tangent plane. The origin is where it comes to rest, the normal is the last quadric's.
///
/// `order`: a spatial order of the points. O(n k).
std::vector<TangentPlane> smoothed_planes(const Neighbours& neighbours, std::span<const Index> order, std::size_t k,
                                          RunContext& context, ProgressShare share);

/// Puts points that came to rest at one place back to where they were, until all origins are distinct, as `points` must
/// be. Returns how many were put back. O(n log n) a round; there is hardly ever a second.
std::size_t separate(std::span<TangentPlane> planes, std::span<const Vec3> points);

}  // namespace geodrome
