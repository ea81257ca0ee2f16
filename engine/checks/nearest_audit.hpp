// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/search/target_list.hpp"
#include "geodrome/engine/audit.hpp"

namespace geodrome {

/// The distances to the nearest of several sources, as they were given to the user, and what they were asked for.
struct GivenNearest {
  std::span<const NamedPoint> sources;
  const TargetList& targets;
  std::span<const Distance> distances;  ///< one a target
  double max_distance = infinity;
};

/// The audit of such distances.
struct NearestAudit {
  std::string not_audited;         ///< the reason, empty if it was by more than reach and straight lines
  std::string search_not_audited;  ///< the reason why the very search was not repeated, empty if it was
  AuditResult search;              ///< of the very search, from all sources with their start distances
  std::size_t targets = 0;         ///< that were held against other searches
  std::size_t from_sources = 0, from_targets = 0;  ///< searches from one source, and from one target to all sources
  std::size_t missed = 0, impossible = 0;  ///< without a distance beside a source's component, and with one outside
  double scale = 0;                        ///< the largest distance or coordinate
  double worst = 0;                        ///< the largest violation by a given distance, over `scale`; at least 0
  std::string where;                       ///< one line for people about it
};

/// Judges them by means that do not share the search: the search is repeated from all sources with Keep::map and
/// audited on a share of the faces, and must give the same; searches from single sources (three, or `share` of them if
/// that is more) must nowhere give less, and not more for the source that is named; searches from three targets must
/// find the same source as far away; no distance is below the straight line. Throws what the solver throws.
NearestAudit audit_nearest(const PreparedSolver& solver, const SurfaceMesh& mesh, const GivenNearest& given,
                           double share, std::uint64_t seed, RunContext& context);

/// What it found that may not be, one line each.
std::vector<std::string> broken_promises(const NearestAudit& audit);

}  // namespace geodrome
