// SPDX-License-Identifier: MIT
#include "engine/checks/matrix_view.hpp"

#include <limits>

namespace geodrome {

namespace {

/// A query's row of the input; one that is no row gets an identity of its own beyond all rows.
std::vector<std::uint64_t> identities(std::span<const NamedPoint> queries, std::uint64_t first_free) {
  std::vector<std::uint64_t> ids;
  for (const NamedPoint& query : queries) ids.push_back(query.row != no_index ? query.row : first_free++);
  return ids;
}

/// Their positions; NaN for one without distances.
std::vector<Vec3> points_of(std::span<const NamedPoint> queries) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Vec3> points;
  for (const NamedPoint& query : queries)
    points.push_back(query.place.has_distances() ? query.place.position : Vec3{nan, nan, nan});
  return points;
}

}  // namespace

Invariants check_invariants(std::span<const NamedPoint> sources, std::span<const NamedPoint> targets,
                            std::function<std::vector<double>(std::uint64_t)> read, const InvariantOptions& options) {
  const std::uint64_t rows_of_input = no_index;
  const auto row_ids = identities(sources, rows_of_input),
             column_ids = identities(targets, rows_of_input + sources.size());
  const auto row_points = points_of(sources), column_points = points_of(targets);
  std::vector<double> starts;
  for (const NamedPoint& source : sources) starts.push_back(source.start);
  return check_invariants({row_ids, column_ids, row_points, column_points, starts, std::move(read)}, options);
}

}  // namespace geodrome
