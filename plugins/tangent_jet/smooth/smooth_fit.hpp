// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/smooth_surface.hpp"

namespace geodrome {

/// The extension SmoothFit of `JetTangents`: quartics at the vertices (vertex_jet.hpp), blended over the faces
/// (jet_surface.hpp), with a measure of trust (trust.hpp). Noise is judged by the sample's own points; where the
/// estimator moved them, quartics are fitted to where it moved them. O(n log n + vertices).
std::unique_ptr<SmoothSurface> fit_smooth_surface(const TangentEstimator& estimator, const SmoothTask& task,
                                                  RunContext& context);

}  // namespace geodrome
