// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "geodrome/surface.hpp"
#include "plugins/tangent_jet/smooth/quartic_fit.hpp"

namespace geodrome {

/// What is known of the noise of a sample.
struct NoiseLeft {
  double sigma = 0;     ///< 0 if there is none
  double left_out = 0;  ///< what jets of so many points that noise is averaged leave out of the shape
};

/// Estimates, per face, how far the blend of its corners' quartics is from the sampled surface: the largest at four
/// places, its middle and those of its edges, of what the residuals and the noise let expect there and what the corners
/// disagree by. Infinite where the corners do not show a smooth surface that the blend is nearer to than the face.
///
/// `jets`: one per vertex. O(V + F).
std::vector<double> face_deviations(const SurfaceMesh& mesh, std::span<const QuarticFit> jets, const NoiseLeft& noise);

}  // namespace geodrome
