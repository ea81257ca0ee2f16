// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "engine/search/source_surface.hpp"
#include "geodrome/engine/audit.hpp"

namespace geodrome {

/// The audit of a few of a job's sources.
struct AuditSummary {
  std::string not_audited;           ///< the reason, empty if it was
  std::vector<std::string> sources;  ///< labels of the sources that were searched again
  AuditResult worst;                 ///< counts summed, worst values over the sources
  double seconds = 0;
};

/// Repeats up to three searches (the first, the middle, the last source on the surface) with Keep::map and audits a
/// share of the faces of each. Each is audited on its own surface. Says "not audited" where `share` is 0 or the solver
/// cannot answer at any point with paths.
AuditSummary audit_sources(const PreparedSolver& solver, const SourceSurfaces& surfaces,
                           std::span<const NamedPoint> sources, double share, std::uint64_t seed, RunContext& context);

}  // namespace geodrome
