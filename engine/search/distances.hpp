// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "engine/search/target_list.hpp"
#include "geodrome/engine/distances.hpp"

/// The one rule of distances, and the four questions that it answers: a row, the nearest source, a pair, a path.
namespace geodrome {

/// Rows of points that were dropped, or are off the part, hold it.
inline constexpr double not_computed = std::numeric_limits<double>::quiet_NaN();

/// False for NaN.
inline bool is_distance(double value) { return value >= 0; }
/// Throws NumericalError: a plugin gave `value`, which is no distance, for `whose`, e.g. "target 5".
[[noreturn]] void throw_no_distance(double value, const std::string& whose);

/// The distance of two places along the surface: NaN if one has no distances; a vertex on no face reaches only itself;
/// else what `searched()` says, which is called only if both lie on the surface.
template <class Searched>
double surface_distance(const Place& from, const Place& to, Searched&& searched) {
  using State = Place::State;
  if (!from.has_distances() || !to.has_distances()) return not_computed;
  if (from.state == State::on_surface && to.state == State::on_surface) return searched();
  return from.state == to.state && from.vertex == to.vertex ? 0 : infinity;
}

/// D(s, t) = start of s + max(surface distance, |st|), and +inf beyond the limit. The straight line counts where the
/// surface is an estimate.
struct DistanceRule {
  bool bounded = false;  ///< the surface is an estimate: see `TargetList::bounded`
  double limit = infinity;

  /// `from_start`: the surface distance with the start distance of `s` added; NaN stays NaN.
  double operator()(double from_start, const NamedPoint& s, const NamedPoint& t) const {
    const double least = bounded ? distance(s.place.position, t.place.position) : 0;
    const double d = std::max(from_start, least + s.start);
    return d > limit ? infinity : d;
  }
};

/// Which targets of a row are read from a map: all, or those at vertices only, where a row is to be replaced by what is
/// carried over a smooth surface; then the others have a number only if they may be within the limit.
enum class Reading { all, vertices };

/// Fills one row: the distances of all targets from one source, on the triangles. Returns the map it was read from,
/// which started at 0, valid until the next run of the search; null if none was needed. Throws what the solver throws,
/// NumericalError for what is no distance.
const ShortestPathMap* distance_row(const PreparedSolver& solver, Search& search, const NamedPoint& source,
                                    const TargetList& targets, double max_distance, RunContext& context,
                                    std::span<double> row, Keep keep = Keep::targets, Reading reading = Reading::all);

/// Is told the map of the search from all sources, null if no search was needed, and what became of it.
using WatchNearest = std::function<void(const ShortestPathMap* map, std::span<const Distance> nearest)>;

/// One search from all sources, on the triangles: the distance of every target from the source that is nearest, and
/// which that is; NaN for a target that has no distances. Throws as `distance_row`, NumericalError for a reach that its
/// distance contradicts, CapabilityError if a start distance is wanted that the solver does not provide.
std::vector<Distance> nearest_distances(const PreparedSolver& solver, std::span<const NamedPoint> sources,
                                        const TargetList& targets, double max_distance, RunContext& context,
                                        const WatchNearest& watch = {}, Keep keep = Keep::targets);

/// The distance of two places on the surface by a search from the one that stops at the other where the solver can.
/// Throws as `distance_row`. Precondition: the solver takes a source and answers there.
double searched_distance(const PreparedSolver& solver, Search& search, const Place& from, const Place& to,
                         RunContext& context);

/// The distance of a pair along the surface, by an oracle that `solver` made; `number` of the pair, for messages. To be
/// called inside `cross_boundary`. Throws as `distance_row`.
double pair_distance(const PairOracle& oracle, const NamedPair& pair, std::size_t number);

/// The shortest path on the triangles of `mesh` from `from`, without its start distance, to the only target. Its
/// distance is the solver's, or the length of the path if that is shorter and the solver does not state that both are
/// one. Throws as `distance_row` and `trace_path`. Precondition: the solver provides paths.
PathResult shortest_path(const PreparedSolver& solver, const SurfaceMesh& mesh, const NamedPoint& from,
                         const TargetList& to, RunContext& context);

}  // namespace geodrome
