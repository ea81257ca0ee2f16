// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <iosfwd>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "geodrome/capabilities.hpp"
#include "geodrome/run_context.hpp"
#include "geodrome/shortest_path_map.hpp"
#include "geodrome/surface.hpp"

namespace geodrome {

/// A point that distances are measured from; `start` >= 0 is added to them.
struct Source {
  SurfacePoint at;
  double start = 0;
};

/// The part of the result that must be kept.
enum class Keep : std::uint8_t {
  targets,  ///< vertices and the given targets only: little memory
  map       ///< any point, and paths
};

/// A request to a search. A solver refuses, with a CapabilityError, what it does not state to provide.
struct Request {
  double radius = std::numeric_limits<double>::infinity();  ///< distances above it are not wanted
  std::span<const SurfacePoint> targets;                    ///< points beside the vertices; must outlive the run
  bool stop_at_targets = false;                             ///< nothing beyond the farthest target is wanted
  Keep keep = Keep::targets;
};

/// A running search: owns its buffers and is used again and again. One per thread.
class GEODROME_VISIBLE Search {
 public:
  virtual ~Search() = default;

  /// Distances from the nearest of `sources` (not empty). The map is valid until the next run. May throw Cancelled.
  virtual const ShortestPathMap& run(std::span<const Source> sources, const Request& request, RunContext& context) = 0;
};

/// Distances between arbitrary pairs of points, after preprocessing. Immutable: every member may be called from several
/// threads at once. May outlive neither the surface that made it nor the plugin.
class GEODROME_VISIBLE PairOracle {
 public:
  virtual ~PairOracle() = default;

  /// The distance of any two points of the surface, >= 0; 0 from a point to itself, +inf between components. The
  /// descriptor's factor holds where it holds for a search: between vertices, between any points with factor_any_point.
  /// The value depends on the two points alone, whichever thread asks and whatever was asked before. Throws InputError
  /// for a point off the mesh.
  virtual double distance(const SurfacePoint& from, const SurfacePoint& to) const = 0;

  /// Writes all that `pair_oracle` needs to answer with the same bytes, from the stream's place on, binary, without
  /// seeking. Mesh, plugin and options need not be told: the engine wraps what is written here with hashes of these, a
  /// length and a checksum. A number for the plugin's own format belongs here, changed whenever that changes. The
  /// engine looks after a stream that fails.
  virtual void save(std::ostream& out) const = 0;
};

/// A mesh made ready for searches: immutable, shared by all threads; its searches may outlive neither it nor the
/// plugin.
class GEODROME_VISIBLE PreparedSurface {
 public:
  virtual ~PreparedSurface() = default;
  /// A new search, which shares this surface and nothing else: searches run on different threads at once. Thread-safe.
  virtual std::unique_ptr<Search> make_search() const = 0;
  /// Memory held beyond the mesh, in bytes. Thread-safe.
  virtual std::size_t bytes() const = 0;
  /// Builds the oracle (`saved` null), or reads one that `PairOracle::save` wrote: from the stream's place, forward
  /// only, to its end. The engine has checked that this was saved by this plugin with these options for this mesh and
  /// seed and that no byte changed; who calls it otherwise has not, so a plugin checks its own format number, and every
  /// count and index before it is used, and reserves no memory on the word of a count alone. Throws InputError
  /// (truncated, syntax) for what it did not write, Cancelled; may use `context.threads()`, on which no answer depends.
  /// Thread-safe. Null unless the solver provides pair_queries.
  virtual std::unique_ptr<PairOracle> pair_oracle(std::istream* /*saved*/, RunContext&) const { return nullptr; }
};

/// Stage 5: shortest paths on a surface (Section 2.4). The guarantee of the distances is the descriptor's `factor`.
class GEODROME_VISIBLE ShortestPathSolver {
 public:
  static constexpr const char* stage = "solver";
  virtual ~ShortestPathSolver() = default;

  /// Makes a mesh ready for searches. The engine has checked the descriptor's `needs` against the mesh. Throws
  /// CapabilityError for a mesh that it cannot work on, InputError for one without geometry, RefusedError for what
  /// would need too much memory, Cancelled. Thread-safe.
  virtual std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext& context) const = 0;
};

/// The distances of all vertices from one source, in the units of the mesh, +inf where not reached: the short way for a
/// single question. Throws what `prepare` and `Search::run` throw. Who asks more than once keeps the prepared surface.
inline std::vector<double> distances(const ShortestPathSolver& solver, MeshPtr mesh, const SurfacePoint& source) {
  QuietContext context;
  const auto prepared = solver.prepare(std::move(mesh), context);
  const auto search = prepared->make_search();
  const Source start{source, 0};
  const auto values = search->run({&start, 1}, {}, context).vertices();
  return {values.begin(), values.end()};
}

}  // namespace geodrome
