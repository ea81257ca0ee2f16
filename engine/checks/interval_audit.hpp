// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "engine/checks/invariants.hpp"
#include "engine/search/prepared_solver.hpp"
#include "geodrome/surface.hpp"

namespace geodrome {

/// What a solver with stated lower bounds says of its intervals.
struct IntervalTerms {
  double factor = infinity;    ///< D <= factor l; +inf: none is promised
  bool never_shorter = false;  ///< d is in [l, D]; else in [l, 2 D - l]
};

/// The intervals that searches certify for the vertices of their surfaces, D a distance and l its lower bound, and how
/// far they are from being any. Sums and maxima: `add` in the order of the rows gives the same for any number of
/// threads.
struct IntervalFigures {
  std::uint64_t vertices = 0;     ///< reached
  double largest = 0, sum = 0;    ///< of (D - l) / l, 0 where both are 0; +inf where l alone is
  double scale = 0;               ///< the largest distance or coordinate
  double worst = 0;               ///< by how much an interval misses what must hold, over the scale; at least 0
  std::uint64_t worst_row = 0;    ///< of the search with the worst one
  Index worst_vertex = no_index;  ///< none if nothing is missed

  /// Rounding of a sum over faces is no miss.
  bool hold() const { return worst <= float64_tolerance; }
  double mean() const { return vertices > 0 ? sum / static_cast<double>(vertices) : 0; }
  /// Adds those of a row.
  void add(const IntervalFigures& row, std::uint64_t number);
};

/// Audits a search by its intervals alone, without a second one. True distances are nowhere steeper than 1, so what
/// must hold at vertices v and u on a common edge of length |vu|, weighted where faces have weights, is
///
///     0 <= l(v) <= D(v) <= factor l(v),    l(v) <= upper(u) + |vu|,
///
/// upper being D or 2 D - l. An error that stays within the intervals passes. `distances` and `bounds`: of all
/// vertices, +inf where nothing was reached. O(V + F).
IntervalFigures audit_intervals(const SurfaceMesh& mesh, std::span<const double> distances,
                                std::span<const double> bounds, const IntervalTerms& terms);

/// Audits a search of this solver on `mesh` so; none if the solver states no lower bounds by an extension.
std::optional<IntervalFigures> audit_intervals(const PreparedSolver& solver, const SurfaceMesh& mesh,
                                               const ShortestPathMap& map);

}  // namespace geodrome
