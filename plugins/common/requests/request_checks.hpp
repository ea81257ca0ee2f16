// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

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
/// and for a start distance that is negative or not finite.
inline void require_valid(const SurfaceMesh& mesh, std::span<const Source> sources, const Request& request) {
  if (sources.empty()) throw CapabilityError("there is no source");
  for (const Source& source : sources) {
    require_on_surface(mesh, source.at, "a source");
    if (!(source.start >= 0 && std::isfinite(source.start)))
      throw InputError(InputFault::range, "a source's start distance is negative or not finite");
  }
  for (const SurfacePoint& target : request.targets) require_on_surface(mesh, target, "a target");
}

/// The distances of a request's targets, kept after the rest is dropped (Keep::targets). Reused from run to run.
class KeptTargets {
  using Entry = std::pair<SurfacePoint, Distance>;
  static auto key(const SurfacePoint& p) { return std::tuple(p.face, p.b[0], p.b[1], p.b[2]); }

 public:
  void clear() { entries_.clear(); }

  /// `distance_of(point)` gives the Distance of each of `targets`. O(t log t).
  template <class Function>
  void assign(std::span<const SurfacePoint> targets, Function&& distance_of) {
    entries_.clear();
    for (const SurfacePoint& target : targets) entries_.emplace_back(target, distance_of(target));
    std::sort(entries_.begin(), entries_.end(),
              [](const Entry& a, const Entry& b) { return key(a.first) < key(b.first); });
  }

  /// The kept distance of exactly this point; throws CapabilityError for any other. O(log t).
  const Distance& at(const SurfacePoint& point) const {
    const auto found = std::lower_bound(entries_.begin(), entries_.end(), point,
                                        [](const Entry& a, const SurfacePoint& b) { return key(a.first) < key(b); });
    if (found == entries_.end() || found->first != point)
      throw CapabilityError("only vertices and the targets were kept", "request Keep::map");
    return found->second;
  }

 private:
  std::vector<Entry> entries_;
};

/// Throws CapabilityError unless the request asked to keep what paths need.
inline void require_paths(Keep keep) {
  if (keep != Keep::map) throw CapabilityError("paths were not kept", "request Keep::map");
}

}  // namespace geodrome
