// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "engine/checks/distance_audit.hpp"
#include "engine/search/source_surface.hpp"

namespace geodrome {

/// The audit of the rows of a matrix.
struct RowsAudit {
  DistanceAudit found;               ///< `worst`: by the rows that were given, and by any search of the job
  std::vector<std::string> sources;  ///< labels of the sources whose rows were audited
  std::uint64_t searches = 0;        ///< of the job, whose distances at all vertices fit their neighbours
  double seconds = 0;                ///< beside the job's searches
};

/// Audits a matrix while and after it is made: every search at all vertices as soon as it is done, and up to three rows
/// as they were given (`audit_distances`): the first, the middle, the last of those whose source lies on the surface,
/// each on its source's own surface.
class RowAudit {
 public:
  /// All must outlive it. `share`: 0 for no audit.
  RowAudit(const PreparedSolver& solver, const SourceSurfaces& surfaces, std::span<const NamedPoint> sources,
           double max_distance, double share);

  /// The places of the sources whose rows `judge` wants.
  std::span<const std::size_t> sources() const noexcept { return chosen_; }

  /// `sources()` holds it: its row is looked at.
  bool looks_at(std::uint64_t source) const { return std::ranges::find(chosen_, source) != chosen_.end(); }

  /// What the search from a source found at the vertices, without the start distance, and the row that was read from
  /// it. Thread-safe. O(F).
  void hear(std::uint64_t source, const SourceSurface& on, std::span<const double> vertices,
            std::span<const double> row);

  /// The rows of `sources()` that were heard, in place of those that were given where these are smooth; one that was
  /// not heard is empty, and is left out by `judge`.
  std::vector<std::vector<double>> heard_rows() const;

  /// `rows`: as they were given, of `sources()`; `rounding`: how far storing an entry may change it, relative to it.
  /// Searches that were not heard are repeated. Throws what the solver throws.
  RowsAudit judge(std::span<const std::vector<double>> rows, double rounding, std::uint64_t seed, RunContext& context);

 private:
  void judge_row(std::size_t source, std::span<const double> row, double rounding, std::uint64_t seed,
                 RunContext& context);

  const PreparedSolver& solver_;
  const SourceSurfaces& surfaces_;
  std::span<const NamedPoint> sources_;
  double max_distance_, share_;
  std::vector<std::size_t> chosen_;
  std::mutex mutex_;
  std::map<std::size_t, std::vector<double>> heard_, rows_;  // of the chosen sources: at vertices, and their rows
  DistanceAudit worst_search_;                               // of all that were heard
  std::uint64_t worst_source_ = std::numeric_limits<std::uint64_t>::max();
  RowsAudit result_;
};

}  // namespace geodrome
