// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "geodrome/run_context.hpp"
#include "geodrome/shortest_path_solver.hpp"
#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/common/exact/found_distance.hpp"
#include "plugins/common/exact/watched_target.hpp"

namespace geodrome {

/// A path that a propagation found to a point. Default constructed, there is none, and its distance is infinite.
template <class W>
concept FoundWay = std::default_initializable<W> && std::copyable<W> && requires(const W& way) {
  { way.distance } -> std::convertible_to<double>;
  { way.source } -> std::convertible_to<Index>;
};

/// The part of a propagation that PropagationSearch uses before a run. A propagation is used again and again, by one
/// thread. The mesh outlives it; `Settings` are those of the solver.
template <class P>
concept StartsOnMesh = requires(P& propagation, const Source& source, Index number) {
  typename P::Settings;
  requires std::constructible_from<P, const PackedMesh&, const typename P::Settings&>;
  /// begin(keep, limit): forgets the last run, even one that was stopped. Nothing beyond the limit is wanted. The run
  /// keeps what `way_to`, `trace` and `trace_from_vertex` need if `keep` is true.
  { propagation.begin(true, 0.0) } -> std::same_as<void>;
  /// seed(source, number): starts at a source. Its start distance is in the packed mesh's units, its point has the face
  /// number of the mesh itself.
  { propagation.seed(source, number) } -> std::same_as<void>;
  /// watched(): the points in faces whose distances the run lowers. Empty after `begin`; filled before `run` in
  /// ascending order of faces; their order stays.
  { propagation.watched() } -> std::same_as<std::vector<Watched>&>;
};

/// The part of a propagation that PropagationSearch runs: run(context, lower_limit) goes on until nothing below the
/// limit is left. The run calls `double lower_limit()` once in `steps_a_poll` of its steps, so that looking at a target
/// costs about one step; the result becomes the limit if it is lower. May throw Cancelled.
template <class P>
concept RunsToLimit = requires(P& propagation, const RunContext& context, double (&lower_limit)()) {
  { P::steps_a_poll } -> std::convertible_to<std::size_t>;
  { propagation.run(context, lower_limit) } -> std::same_as<void>;
};

/// The part of a propagation that PropagationSearch uses after a run. Distances are in the units of the packed mesh.
template <class P>
concept AnswersAfterRun = FoundWay<typename P::Way> &&
    requires(const P& propagation, const SurfacePoint& inner, const typename P::Way& way, Index vertex,
             std::vector<SurfacePoint>& out) {
  { propagation.watched() } -> std::same_as<const std::vector<Watched>&>;
  /// answer(vertex): the distance of every vertex below the limit. reached(): the vertices that have one, each once.
  { propagation.answer(vertex) } -> std::same_as<FoundDistance>;
  { propagation.reached() } -> std::convertible_to<const std::vector<Index>&>;
  /// way_to(inner, best): the shortest path through anything that was kept to a point that is no vertex, named in the
  /// packed mesh; none unless it is shorter than `best`.
  { propagation.way_to(inner, 0.0) } -> std::same_as<typename P::Way>;
  /// trace(way, out): appends the points of a path between its two ends, with the face numbers of the mesh itself.
  { propagation.trace(way, out) } -> std::same_as<void>;
  /// trace_from_vertex(vertex, out): appends the points of the shortest path to a vertex with a label; the vertex
  /// itself comes first. Appends nothing if the vertex is a source.
  { propagation.trace_from_vertex(vertex, out) } -> std::same_as<void>;
  /// counters(): an array of Counter. The last is "largest_search_bytes", the memory of the propagation.
  { propagation.counters().back() } -> std::convertible_to<Counter>;
};

/// A propagation of distances over a packed mesh, which PropagationSearch makes into a search. VertexPropagation has
/// `seed`, `watched`, `run`, `answer` and `reached`.
template <class P>
concept MeshPropagation = StartsOnMesh<P> && RunsToLimit<P> && AnswersAfterRun<P>;

/// A propagation that tells beside its distances how short the true ones can be at least.
template <class P>
concept KnowsLowerBounds = MeshPropagation<P> && requires(const P& propagation, Index vertex) {
  /// lower_bound(vertex): no path below the limit is shorter. Infinite where nothing was found.
  { propagation.lower_bound(vertex) } -> std::same_as<double>;
  /// factor(): no distance of this run, at any point, is longer than so many times the true one.
  { propagation.factor() } -> std::same_as<double>;
};

}  // namespace geodrome
