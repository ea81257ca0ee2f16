// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "geodrome/run_context.hpp"
#include "geodrome/surface.hpp"
#include "geodrome/tangent_estimator.hpp"

namespace geodrome {

/// A question to a smooth surface: what is above `at`, and how does it change in the plane of the face?
struct SmoothPlace {
  SurfacePoint at;  ///< its coordinates sum to 1; they may be negative: beside the face, in its plane
  Vec3 direction;   ///< a unit vector in the plane of the face
};

/// The answer: a point of the smooth surface, and its derivatives by the length that `at` moves along `direction`.
struct SmoothPoint {
  Vec3 position;
  Vec3 normal;           ///< unit length, on the side of the face's own normal
  Vec3 velocity;         ///< of the position
  Vec3 acceleration;     ///< second derivative of the position
  Vec3 normal_velocity;  ///< of the normal
};

/// A smooth surface over the faces of a mesh: a chart a face, continuous across edges between trusted faces. Immutable,
/// shared by all threads.
class GEODROME_VISIBLE SmoothSurface {
 public:
  virtual ~SmoothSurface() = default;

  /// Returns how far this surface is estimated to be from the one that was sampled, at most above a face, in units of
  /// the mesh; infinite where the fit is not to be trusted, so that the flat face stays. O(1).
  virtual double deviation(Index face) const = 0;

  /// Answers all places; the faces must be trusted. Positions and first derivatives are exact, second ones at least of
  /// the accuracy that Newton's method needs. O(places).
  virtual void evaluate(std::span<const SmoothPlace> places, std::span<SmoothPoint> points) const = 0;

  virtual std::size_t bytes() const = 0;
};

/// What a smooth surface is fitted to: a mesh with the points of the surface it was made from. All of them outlive
/// neither the call nor are held by the result, but for the mesh.
struct SmoothTask {
  MeshPtr mesh;
  const PointSample& sample;  ///< the whole sample, as it was given to the estimator
  const Tangents& tangents;   ///< what the estimator made of it; what it dropped is left out
};

/// Extension (README.md, "Extensions") of a tangent estimator that knows more of the surface than its planes.
struct SmoothFit {
  static constexpr const char* id = "geodrome.smooth_fit/1";

  /// Fits a smooth surface over the faces of a mesh. Throws Cancelled; a sample that is too coarse, too rough or too
  /// noisy makes faces that are not trusted, never an error. May use `context.threads()`, on which no result depends.
  /// Thread-safe.
  std::unique_ptr<SmoothSurface> (*fit)(const TangentEstimator& estimator, const SmoothTask& task, RunContext& context);
};

}  // namespace geodrome
