// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <iosfwd>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/shortest_path_solver.hpp"

namespace geodrome::bench {

struct MatrixRowsOptions {
  std::size_t rows = 200;  ///< random vertices; 0: all
  std::size_t chunk = 16;  ///< rows that one of the two makes before the other has its turn
  unsigned threads = 1;    ///< of preparing and of the rows; 0: one per core
  double radius = std::numeric_limits<double>::infinity();
  bool of_rows_alone = false;  ///< the plan holds the rows that are made, not all vertices
  std::uint64_t seed = 1;      ///< chooses the rows
};

/// Processor seconds, all threads together.
struct MatrixLane {
  std::string name;
  double preparation = 0;  ///< of the surface and, for the solver, of the plan
  double preparation_by_clock = 0;
  std::size_t bytes = 0;      ///< of the prepared surface, that of the plan if it is used
  std::vector<double> chunk;  ///< per chunk, over its rows
};

struct MatrixRowsResult {
  MatrixLane solver, peer;
  bool used = false;                       ///< false: the solver found that the plan would not pay
  std::map<std::string, double> measures;  ///< of the plan
  std::size_t vertices = 0;                ///< on faces: rows of a whole matrix
  std::size_t rows = 0;                    ///< made by both
  double worst_difference = 0;  ///< of solver and peer over the largest distance of the row; +inf: one has none
  double worst_asymmetry = 0;   ///< |D(i, j) - D(j, i)| of the solver's rows i, j over the largest distance of row i
};

/// Times rows of a matrix by what a solver prepares for all of them (extension ManySearches) against plain rows by a
/// peer, interleaved chunk by chunk: A B B A. A row is a search from a vertex and the copy of all vertex distances; a
/// thread keeps one search of each, which has made the first row before the clock starts. Memory: rows^2 / 2 numbers
/// for the asymmetry. Throws CapabilityError if the mesh lacks what one of them needs, or the solver has no such
/// extension, and what the solvers throw.
MatrixRowsResult matrix_rows(const Plugin<ShortestPathSolver>& solver, const Plugin<ShortestPathSolver>& peer,
                             const MeshPtr& mesh, const MatrixRowsOptions& options);

/// Processor seconds of a whole matrix, preparing included, if all rows take what those that were made did.
double whole_matrix(const MatrixLane& lane, const MatrixRowsResult& result);

/// Prints times and ratios, solver over peer: below 1 the solver is faster.
void print(std::ostream& out, const MatrixRowsResult& result);

}  // namespace geodrome::bench
