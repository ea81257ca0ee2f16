// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "geodrome/engine/selection.hpp"

/// Sources and targets as the rows and columns of a MatrixView.
namespace geodrome {

/// A query's row of the input; one that is no row gets an identity of its own beyond all rows.
inline std::vector<std::uint64_t> identities(std::span<const Query> queries, std::uint64_t first_free) {
  std::vector<std::uint64_t> ids;
  for (const Query& query : queries) ids.push_back(query.row != no_index ? query.row : first_free++);
  return ids;
}

/// Their positions; NaN for one that was dropped.
inline std::vector<Vec3> points_of(std::span<const Query> queries) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Vec3> points;
  for (const Query& query : queries)
    points.push_back(query.place.state == Place::State::dropped ? Vec3{nan, nan, nan} : query.place.position);
  return points;
}

}  // namespace geodrome
