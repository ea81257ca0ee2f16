// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "geodrome/engine/distances.hpp"
#include "geodrome/engine/matrix_file.hpp"
#include "geodrome/engine/named_points.hpp"
#include "geodrome/engine/observer.hpp"
#include "geodrome/engine/pipeline.hpp"
#include "geodrome/engine/surface_jobs.hpp"

namespace geodrome {

/// Distances from sources to targets: Algorithm 2. Paths that are empty are not written.
struct DistanceJob {
  std::filesystem::path input;
  RunSettings settings;
  std::string sources = "all", targets = "all";  ///< see `select`
  ProjectionRule query = ProjectionRule::project;
  double max_distance = infinity;  ///< farther is +inf
  ScalarType scalar = ScalarType::float64;
  std::filesystem::path matrix;   ///< .npy or .csv
  std::filesystem::path bounds;   ///< lower bounds of the entries of `matrix`, in its layout
  std::filesystem::path nearest;  ///< .csv: one search from all sources at once
  bool nearest_bounds = false;    ///< a column with lower bounds in `nearest`
  std::filesystem::path surface;  ///< the mesh that was used
  std::filesystem::path report;   ///< .json
  bool resume = false;            ///< go on with MATRIX.partial
  bool yes = false;               ///< consent to more than 4 GB
  double audit_share = 0.01;      ///< of the faces; 0: no audit
};

/// The run report as JSON text, and a few lines for people.
/// `broken_promises` is empty if all checks passed: invariants that the solver's guarantee promises, reach within and
/// across components, the audit. Outputs are written all the same, for inspection; do not trust them then.
struct JobReport {
  std::string json, summary;
  std::vector<std::string> broken_promises;
};

/// Does the whole job: reads, runs the stages, computes, checks, writes. Files appear whole or not at all, but for
/// MATRIX.partial, which an interrupted job leaves for `resume`. Throws any geodrome::Error. Memory: the surface, the
/// prepared solver, and O(targets) per thread. InputError for a source off the part, unless `sources` is "all".
///
/// No true distance on the surface is below its lower bound: what the solver states by the extension LowerBounds, else
/// D / factor, so D itself for an exact solver; up to rounding. CapabilityError for lower bounds by a solver that has
/// neither. Of what is unreachable the bound is +inf, of what lies beyond `max_distance` a finite number.
JobReport run_distances(const DistanceJob& job, Observer& observer);

/// Distances of many pairs of points, by the oracle of a solver that provides pair_queries; under the smooth metric by
/// a search from every point that pairs begin at, by a solver that provides paths. Points of a cloud lie at their
/// closest surface points, D = max(surface distance, |st|).
struct PairJob {
  std::filesystem::path input;
  RunSettings settings;
  std::filesystem::path pairs;   ///< a pair a line: see `select_pairs`
  std::filesystem::path out;     ///< .npy (float64, one a pair) or .csv (pair,from,to,distance,reach)
  std::filesystem::path index;   ///< the oracle: read if the file is there, else built and saved there; empty: built;
                                 ///< no smooth distances are made by it
  std::filesystem::path report;  ///< .json
};

/// Does the whole job, as `run_distances`, with the same bytes in `out` for any number of threads and whether the
/// oracle was built or read; +inf: unreachable, NaN: a row was dropped or is off the part. `broken_promises` tells of
/// reach within and across components, D(s, s), D >= Euclid, and a few pairs against searches. Throws any
/// geodrome::Error:
/// CapabilityError for another solver, InputError for pairs that cannot be read and for an index that is damaged or
/// belongs to another mesh, solver, option or seed. Memory: the surface, the prepared solver, the oracle (twice while
/// it is saved), and O(pairs).
JobReport run_pairs(const PairJob& job, Observer& observer);

/// One shortest path. `.obj` (a polyline), `.csv` (x,y,z,face,b0,b1,b2) or `.json` by the name's ending.
struct PathJob {
  std::filesystem::path input;
  RunSettings settings;
  std::string from, to;                            ///< one entry each, as `select` reads it
  ProjectionRule query = ProjectionRule::project;  ///< not `printed`, whose minima are lengths of no path
  std::filesystem::path out;
  std::filesystem::path flat;  ///< under the smooth metric: the path on the triangles, with its length as distance
};

/// Does the whole job, as `run_distances`, and gives the path back; `out` and `flat` may be empty. Throws any
/// geodrome::Error: CapabilityError for a solver without paths, OptionError for an end that was dropped, has a start
/// distance or is not one point. `broken_promises` of the path tells of its audit: see `Session::audit_path`. Memory:
/// the surface, the prepared solver, and the map of one search.
PathResult run_path(const PathJob& job, Observer& observer);

/// Distances by every combination of chosen plugins: what each costs, on one thread, and how far it is off; under the
/// smooth metric on the triangles and on the smooth surface.
struct CompareJob {
  std::filesystem::path input;
  RunSettings settings;                 ///< `stages`: of those that are not varied; `threads` is not used
  std::vector<std::string> varied;      ///< "STAGE=A,B:k=v,...", one for each stage that is varied
  std::string sources = "0";            ///< see `select`; targets are all rows
  std::string truth = "first";          ///< "first" that ran, "exact[:SOLVER]" on the same surface, or a .npy
  unsigned growth = 0;                  ///< finer meshes (faces cut in 4), or sparser samples (halved), so many times
  unsigned paths = 4;                   ///< per source, for the page
  std::filesystem::path figures;        ///< .json
  std::filesystem::path page;           ///< .html
  std::filesystem::path page_template;  ///< empty: the one that came with the engine
};

/// The figures as JSON and as a table. `error_status`: of the first combination that did not run, 0 if all ran.
/// `broken_promises`: invariants, reach and guarantees of the combinations that do not hold.
struct CompareReport {
  std::string json, table;
  int error_status = 0;
  std::vector<std::string> broken_promises;
};

/// Does the whole job, in child processes (fork): plugins are loaded there, and one that dies loses its combination
/// alone. No other thread may load plugins meanwhile. `observer` is told on this thread. A combination that cannot be
/// run is a row of its own, the others go on. Throws any
/// geodrome::Error for what is wrong with the job itself: OptionError for stages, sources and truth that do not exist,
/// InputError for a truth of another shape, CapabilityError for a page whose template is missing. Memory: the surfaces
/// that differ, one prepared solver, and rows of all targets per source.
CompareReport run_compare(const CompareJob& job, Observer& observer);

/// The exit status that stands for an error: 2 usage, 3 input, file system or capability, 4 refused or out of memory,
/// 5 plugin, 130 cancelled, else 1.
int exit_status(const std::exception& error) noexcept;

}  // namespace geodrome
