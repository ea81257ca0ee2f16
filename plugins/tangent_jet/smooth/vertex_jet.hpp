// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "plugins/tangent_jet/smooth/fit_size.hpp"
#include "plugins/tangent_jet/smooth/jet_points.hpp"
#include "plugins/tangent_jet/smooth/quartic_fit.hpp"

namespace geodrome {

/// Fits the quartic of a vertex, over its own tangent plane, to the points within `reach`, but at least the nearest 32
/// and at most 512. Their number is doubled while the residual does not grow with it, as that of noise does not; that
/// of a clean smooth shape grows tenfold. Where it was doubled, and where the estimator found noise, the quartic has a
/// constant. With noise it is doubled up to `noisy`.points at most, and its degree is `noisy`.degree. `around` is a
/// buffer.
QuarticFit vertex_jet(const JetPoints& points, const Vec3& vertex, double reach, const FitSize& noisy,
                      std::vector<Neighbour>& around);

}  // namespace geodrome
