// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "geodrome/surface.hpp"
#include "plugins/tangent_jet/smooth/quartic_fit.hpp"

namespace geodrome {

/// Estimates, per face, how far the blend of its corners' quartics is from the sampled surface: the largest at four
/// places, its middle and those of its edges, of what the residuals let expect there and what the corners disagree by.
/// Infinite where the corners do not show a smooth surface that the blend is nearer to than the face.
///
/// `jets`: one per vertex. `sigma`: the noise of the sample, 0 if none. O(V + F).
std::vector<double> face_deviations(const SurfaceMesh& mesh, std::span<const QuarticFit> jets, double sigma);

}  // namespace geodrome
