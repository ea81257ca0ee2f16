// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <span>
#include <string>

#include "geodrome/shortest_path_solver.hpp"
#include "geodrome/surface.hpp"

namespace geodrome {

/// Barycentric coordinates may miss the sum 1 by rounding; more than this is a caller's mistake.
inline constexpr double barycentric_tolerance = 1e-9;

/// Throws InputError (index or range) unless `point` names a face of `mesh` and coordinates >= 0 of sum 1. `what` names
/// the point in the message.
inline void require_on_surface(const SurfaceMesh& mesh, const SurfacePoint& point, const char* what) {
  if (point.face >= mesh.face_count())
    throw InputError(InputFault::index, std::string(what) + " names face " + std::to_string(point.face) + " of " +
                                            std::to_string(mesh.face_count()));
  const auto& b = point.b;
  if (!(b[0] >= 0 && b[1] >= 0 && b[2] >= 0 && std::abs(b[0] + b[1] + b[2] - 1) <= barycentric_tolerance))
    throw InputError(InputFault::range, std::string(what) + " on face " + std::to_string(point.face) +
                                            " has barycentric coordinates that are negative or do not sum to 1");
}

/// Throws CapabilityError for a request without sources, InputError for a source or target that is not on the surface
/// and for a start distance that is negative or not finite. O(sources + targets).
inline void require_valid(const SurfaceMesh& mesh, std::span<const Source> sources, const Request& request) {
  if (sources.empty()) throw CapabilityError("there is no source");
  for (const Source& source : sources) {
    require_on_surface(mesh, source.at, "a source");
    if (!(source.start >= 0 && std::isfinite(source.start)))
      throw InputError(InputFault::range, "a source's start distance is negative or not finite");
  }
  for (const SurfacePoint& target : request.targets) require_on_surface(mesh, target, "a target");
}

/// Throws CapabilityError for a mesh with face weights: for solvers that do not provide them.
inline void require_unweighted(const SurfaceMesh& mesh) {
  if (!mesh.face_weights().empty())
    throw CapabilityError("face weights are not supported", "choose a solver that provides weights");
}

/// Throws CapabilityError unless the request asked to keep what paths need.
inline void require_paths(Keep keep) {
  if (keep != Keep::map) throw CapabilityError("paths were not kept", "request Keep::map");
}

}  // namespace geodrome
