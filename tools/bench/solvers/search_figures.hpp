// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geodrome/shortest_path_map.hpp"

namespace geodrome::bench {

/// A figure that not every solver has.
using Figure = std::optional<double>;

/// What a solver counted in one search.
struct SearchFigures {
  Figure windows;  ///< windows_propagated: taken across a face, the unit of work of exact window solvers
  Figure bytes;    ///< largest_search_bytes: held by the search, at most
};

SearchFigures figures_of(std::span<const Counter> counters);

/// None if one of the two is none, or the divisor is 0.
Figure quotient(Figure dividend, Figure divisor);

/// None if one of them is none. Precondition: not empty.
Figure median_figure(std::span<const Figure> figures);
Figure largest_figure(std::span<const Figure> figures);

/// With that many decimals; "-" for none and for what is not finite.
std::string figure_text(Figure figure, int decimals);

/// Edges of the mesh, each once however many faces it has. O(F log F).
std::size_t edge_count(const SurfaceMesh& mesh);

}  // namespace geodrome::bench
