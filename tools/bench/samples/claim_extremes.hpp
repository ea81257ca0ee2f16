// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "engine/checks/claims.hpp"

namespace geodrome::bench {

/// The paper's constants over many surfaces: the extremes of what was measured, and how often each bound held.
class ClaimExtremes {
 public:
  /// Adds the claims that the engine makes about a surface from points.
  void add(const PlacedSurface& surface, std::uint64_t seed);

  /// A line per claim; nothing if no surface was added.
  void print(std::ostream& out) const;

 private:
  struct Row {
    Claim claim;
    double least = 0, most = 0;
    std::size_t held = 0, measured = 0;
  };
  std::vector<Row> rows_;
};

}  // namespace geodrome::bench
