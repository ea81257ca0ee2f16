// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geodrome/errors.hpp"
#include "geodrome/surface.hpp"

namespace geodrome {

/// The reason why a distance is +inf, or `reached` if it is finite.
enum class Reach : std::uint8_t {
  reached,
  beyond_limit,  ///< farther than the request's radius, or not reached because the search was stopped early
  unreachable    ///< in a component without a source
};

/// `value` is +inf unless `reach` is reached; `source` is the index of the nearest source in the request, no_index if
/// there is none.
struct Distance {
  double value = std::numeric_limits<double>::infinity();
  Reach reach = Reach::unreachable;
  Index source = no_index;
};

/// A named figure of a search, for the run report, which adds them up over the searches; a name that starts with
/// "largest_" is combined by maximum instead.
struct Counter {
  const char* name;
  std::uint64_t value;
};

/// The result of one search: distances from the nearest source, and the way to it. Valid until the next run of the
/// search that made it. What the request did not ask to keep is refused with a CapabilityError, never guessed.
class GEODROME_VISIBLE ShortestPathMap {
 public:
  virtual ~ShortestPathMap() = default;

  /// One distance per vertex of the mesh; +inf where not reached (whatever the reason), also at vertices on no face.
  virtual std::span<const double> vertices() const = 0;

  /// The distance at a surface point. With Keep::targets only vertices and the request's targets may be asked.
  virtual Distance at(const SurfacePoint& point) const = 0;

  /// Replaces `out` by a shortest path from `point` to its nearest source: surface points whose consecutive pairs lie
  /// in a common face. Its length plus the source's start distance is the distance (exact solvers: to 1e-12 relative);
  /// unless a solver states path_is_distance, both agree within its factor only, and the path may be the shorter one.
  /// Empty if the point was not reached. Needs Keep::map.
  virtual void path(const SurfacePoint& point, std::vector<SurfacePoint>& out) const = 0;

  /// Returns what the search counted, for the run report. Names are snake case: a-z, 0-9 and _, from a letter; each is
  /// there once.
  virtual std::span<const Counter> counters() const = 0;
};

}  // namespace geodrome
