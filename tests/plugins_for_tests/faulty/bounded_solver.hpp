// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/lower_bounds.hpp"
#include "tests/plugins_for_tests/faulty/faulty_solver.hpp"

namespace geodrome::faulty {

/// Lower bounds that `bound_of` makes of the distances of an exact solver.
template <double (*bound_of)(const Distance&)>
constexpr LowerBounds bounds_by{
    [](const ShortestPathMap& map, std::span<double> bounds) noexcept {
      for (std::size_t v = 0; v < bounds.size(); ++v) {
        const double value = map.vertices()[v];
        bounds[v] = bound_of({value, value < infinity ? Reach::reached : Reach::beyond_limit, 0});
      }
    },
    [](const ShortestPathMap& map, const SurfacePoint& point) { return bound_of(map.at(point)); }};

}  // namespace geodrome::faulty

#define GEODROME_BOUNDED_SOLVER(bounds, plugin_name)                                                                 \
  GEODROME_PLUGIN(geodrome::faulty::FaultySolver<geodrome::faulty::NoFault>, .name = plugin_name,                    \
                  .summary = "a faulty solver", .licence = "MIT", .provides = geodrome::test::ExactSolver::provides, \
                  .factor = geodrome::exact_factor, .extension = geodrome::extensions<bounds>)
