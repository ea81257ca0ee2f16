// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/engine/pipeline.hpp"

/// The smooth surface over the faces of a mesh: what a tangent estimator makes of it by the extension SmoothFit.
namespace geodrome {

/// Loads the tangent estimator that `settings` names. Throws as PluginHost::load, and CapabilityError if it fits no
/// smooth surfaces.
Plugin<TangentEstimator> load_smooth_estimator(const PluginHost& host, const RunSettings& settings);

/// Fits a smooth surface over the faces of a surface that was made: to its sample as it was read, or, of a mesh, to its
/// vertices, then `sample` is not used. Throws CapabilityError for a mesh with weights, SampleError for vertices that
/// stage 1 refuses, PluginError for a result that breaks the interface, and as `load_smooth_estimator`.
FittedSurface fit_smooth(const PlacedSurface& surface, const PointSample& sample, const PluginHost& host,
                         const RunSettings& settings, Observer& observer);

}  // namespace geodrome
