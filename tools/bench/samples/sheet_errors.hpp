// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "geodrome/engine/pipeline.hpp"
#include "geodrome/engine/plugin_host.hpp"
#include "tools/bench/samples/distance_errors.hpp"

namespace geodrome::bench {

/// How a surface made from a sample of a sheet differs from the sheet, whose distances are known exactly.
struct SheetErrors {
  DistanceErrors distances;   ///< from 5 seeded points to all, as the product gives them
  double short_vertices = 0;  ///< the same between vertices far apart: what is too short most, as a share
  std::size_t shortcuts = 0;  ///< edges that are over 1.6 times as long in the sheet: they join two parts of it
};

/// `kind`: of shapes::sheet_kinds(). `sample`: the points that `surface` was made from. Distances are those of
/// `chen_han`. Throws what loading and running it throws.
SheetErrors sheet_errors(const std::string& kind, const PointSample& sample, const PlacedSurface& surface,
                         const PluginHost& host, std::uint64_t seed);

/// A sheet is wrong if two parts of it are joined, or vertices are more than 2 % too near to each other; empty if not.
std::string how_wrong(const SheetErrors& errors);

}  // namespace geodrome::bench
