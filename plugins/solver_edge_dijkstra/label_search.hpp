// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geodrome/run_context.hpp"
#include "geodrome/solver_kit/indexed_heap.hpp"
#include "plugins/solver_edge_dijkstra/edge_graph.hpp"

namespace geodrome {

/// Dijkstra's search from any number of labelled starts. A label is (distance, source); of two labels the lower one
/// stays, so that ties go to the lowest source. The queue compares distances, then vertices: a vertex whose label is
/// lowered at the same distance goes back into the queue, and is counted as settled again. Labels do not depend on the
/// order in which vertices at the same distance leave the queue; of ways as short from the same source, the one through
/// the vertex that leaves first is kept.
///
/// Reused: a new search costs what the last one reached. Not to be copied or shared between threads.
class LabelSearch {
 public:
  explicit LabelSearch(const EdgeGraph& graph);
  LabelSearch(const LabelSearch&) = delete;
  LabelSearch& operator=(const LabelSearch&) = delete;

  /// Forgets the last search.
  void clear();
  /// Offers a vertex a distance from source `source` that is not through another vertex.
  void seed(Index vertex, double distance, Index source) { relax(vertex, distance, source, no_index); }
  /// The search may stop when every wanted vertex that can be reached is settled.
  void want(Index vertex);

  /// Settles every vertex up to `radius`, or up to the farthest wanted one if `stop_at_wanted`. The others stay +inf.
  void run(double radius, bool stop_at_wanted, const RunContext& context);

  std::span<const double> distances() const { return distance_; }
  Index source(Index vertex) const { return source_[vertex]; }
  /// The vertex before on the way from the source; no_index where the way starts.
  Index previous(Index vertex) const { return previous_[vertex]; }
  /// All vertices that are not farther are settled.
  double limit() const { return limit_; }
  std::uint64_t settled() const { return settled_; }

 private:
  void relax(Index vertex, double distance, Index source, Index previous);
  void drop_unsettled();

  const EdgeGraph& graph_;
  std::vector<double> distance_;
  std::vector<Index> source_, previous_;
  std::vector<char> wanted_;
  std::vector<Index> touched_;
  IndexedHeap queue_;
  std::size_t open_wanted_ = 0;
  double limit_ = infinity;
  std::uint64_t settled_ = 0;
};

}  // namespace geodrome
