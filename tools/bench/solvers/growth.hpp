// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <iosfwd>
#include <span>

#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/shortest_path_solver.hpp"
#include "tools/bench/solvers/search_figures.hpp"

namespace geodrome::bench {

struct GrowthOptions {
  std::size_t sources = 1;  ///< random vertices
  std::size_t runs = 3;     ///< from each source
  std::uint64_t seed = 1;   ///< chooses the sources
};

/// What a solver took on one mesh; medians over the sources.
struct GrowthPoint {
  std::size_t faces = 0, edges = 0;
  Figure windows;
  double seconds = 0;  ///< of a query: median over the runs of a source, then over the sources
  Figure bytes;        ///< held by the search, at most, over the sources
};

/// One thread. A query is one search and the copy of all vertex distances; the search is made once and used again, and
/// has one query from each source before the clock starts. Throws CapabilityError if the mesh lacks what the solver
/// needs, and what the solver throws.
GrowthPoint growth_point(const Plugin<ShortestPathSolver>& solver, const MeshPtr& mesh, const GrowthOptions& options);

/// The exponents in the number of faces that fit best; none for fewer than two numbers of faces, or where a solver does
/// not count windows.
struct GrowthExponents {
  Figure windows, seconds;
};
GrowthExponents exponents_of(std::span<const GrowthPoint> points);

void print_growth_head(std::ostream& out);
void print(std::ostream& out, const std::string& shape, const GrowthPoint& point);
void print(std::ostream& out, const std::string& shape, const GrowthExponents& exponents);

}  // namespace geodrome::bench
