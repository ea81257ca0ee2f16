// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "engine/search/source_surface.hpp"
#include "geodrome/engine/audit.hpp"

namespace geodrome {

/// Violations beyond this share of the largest distance are no rounding: an exact solver's stay below 1e-11, and a
/// wavefront that is lost, or a path that is not shortest, shows by far more.
inline constexpr double audit_tolerance = 1e-9;

/// The audit of a few of a job's sources.
struct AuditSummary {
  std::string not_audited;           ///< the reason, empty if it was
  std::vector<std::string> sources;  ///< labels of the sources that were searched again
  AuditResult worst;                 ///< counts summed, worst values over the sources
  double worst_given = 0;            ///< by how much rows that were given miss those of these searches, over the scale
  std::string where_given;           ///< one line for people about it
  double seconds = 0;
};

/// Rows of a matrix as they were given to the user.
struct GivenRows {
  std::vector<std::vector<double>> rows;  ///< of `audited_sources`, in their order; empty: there is no matrix
  double max_distance = infinity;
  double rounding = 0;  ///< how far storing an entry may change it, relative to it
};

/// The places in the list of the sources whose searches are repeated: the first, the middle, the last on the surface.
std::vector<std::size_t> audited_sources(std::span<const NamedPoint> sources);

/// Repeats up to three searches (the first, the middle, the last source on the surface) with Keep::map and audits a
/// share of the faces of each. Each is audited on its own surface. Says "not audited" where `share` is 0 or the solver
/// cannot answer at any point with paths. Where a factor is promised, the rows that were given must be those of these
/// searches.
AuditSummary audit_sources(const PreparedSolver& solver, const SourceSurfaces& surfaces,
                           std::span<const NamedPoint> sources, const GivenRows& given, double share,
                           std::uint64_t seed, RunContext& context);

}  // namespace geodrome
