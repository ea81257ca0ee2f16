// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "geodrome/surface.hpp"
#include "plugins/tangent_jet/smooth/quartic_fit.hpp"

namespace geodrome {

/// Estimates, per face, how far the blend of its corners' quartics is from the sampled surface: the largest of four
/// places (the middle and those of the edges) of the residuals times the leverages of the corners, weighted as the
/// blend is. Infinite where the corners do not show a smooth surface that the blend is nearer to than the face.
///
/// `jets`: one per vertex. `sigma`: the noise of the sample, 0 if none. O(faces).
std::vector<double> face_deviations(const SurfaceMesh& mesh, std::span<const QuarticFit> jets, double sigma);

}  // namespace geodrome
