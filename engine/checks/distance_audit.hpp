// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "engine/search/target_list.hpp"
#include "geodrome/engine/audit.hpp"

namespace geodrome {

/// Violations beyond this share of the scale are no rounding: an exact solver's stay below 1e-11, and a wavefront that
/// is lost, or a path that is not shortest, shows by far more.
inline constexpr double audit_tolerance = 1e-9;

/// Distances as they were given to the user, and what they were asked for: those from the nearest of several sources,
/// or a row of a matrix.
struct GivenDistances {
  std::span<const NamedPoint> sources;
  const TargetList& targets;
  std::span<const Distance> distances;  ///< one a target
  double max_distance = infinity;
  /// What the very search found at the vertices, as it gave it: of a row without the start distance, and audited before
  /// (`audit_vertices`). Empty: it is searched again.
  std::span<const double> vertices = {};
  std::size_t rows = 0;  ///< of the matrix that this is a row of, each of one source; 0: the nearest of all sources
  double rounding = 0;   ///< how far storing a distance may change it, relative to it
};

/// The audit of such distances.
struct DistanceAudit {
  std::string not_audited;         ///< the reason, empty if it was by more than reach and straight lines
  std::string search_not_audited;  ///< the reason why no map of the very search was audited, empty if it was
  AuditResult search;              ///< of such a map, from all sources with their start distances
  std::size_t targets = 0;         ///< that were held against other searches
  std::size_t from_sources = 0, from_targets = 0;  ///< searches from one source, and from one target to all sources
  std::size_t missed = 0, impossible = 0;  ///< without a distance beside a source's component, and with one outside
  double scale = 0;                        ///< the largest distance or coordinate
  double worst = 0;                        ///< the largest violation by a given distance, over `scale`; at least 0
  std::string where;                       ///< one line for people about it

  double worst_of_all() const { return std::max({worst, search.worst_lipschitz, search.worst_path}); }
  /// Counts are summed up, the worse of each violation stays.
  void add(const DistanceAudit& other);
};

/// Judges them at a small part of the cost of the searches that gave them; checks/README.md says what each check proves
/// and what it cannot see. What the very search found fits together at all vertices, and the given distances fit
/// it; none is below the straight line. Around the sources, on four times `share` of the faces, the search is repeated
/// with Keep::map, must find the same and is audited. Searches from single sources (three) must nowhere give less, and
/// not more for the source that is named; searches from targets (three, of a row one) must find the same source as far
/// away: both within a part of the surface that is smaller the less was searched, the whole with 100 sources or rows.
/// With a share of a quarter or more the whole search is repeated, and single ones from that share of the sources.
/// Throws what the solver throws.
DistanceAudit audit_distances(const PreparedSolver& solver, const SurfaceMesh& mesh, const GivenDistances& given,
                              double share, std::uint64_t seed, RunContext& context);

/// The part of it that holds what a search found at the vertices against their neighbours (checks/lipschitz.hpp).
/// `limit`: of the search; `from`: words for its sources. O(F).
DistanceAudit audit_vertices(const SurfaceMesh& mesh, std::span<const double> vertices, double factor, double limit,
                             std::span<const Source> sources, const std::string& from);

/// What it found that may not be, one line each.
std::vector<std::string> broken_promises(const DistanceAudit& audit);

}  // namespace geodrome
