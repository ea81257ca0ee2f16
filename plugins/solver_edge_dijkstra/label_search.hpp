// SPDX-License-Identifier: MIT
#pragma once

#include <boost/graph/detail/d_ary_heap.hpp>
#include <boost/property_map/property_map.hpp>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "geodrome/run_context.hpp"
#include "plugins/solver_edge_dijkstra/edge_graph.hpp"

namespace geodrome {

/// Dijkstra's search from any number of labelled starts, with Boost.Graph's indexed heap. A label is (distance,
/// source); of two labels the lower one stays, so that ties go to the lowest source. The heap compares distances alone:
/// a vertex whose label is lowered at the same distance goes back into the heap, and is counted as settled again.
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
  using Places = boost::iterator_property_map<std::size_t*, boost::typed_identity_property_map<Index>>;
  using Heap = boost::d_ary_heap_indirect<Index, 4, Places, const double*, std::less<double>>;

  void relax(Index vertex, double distance, Index source, Index previous);
  void drop_unsettled();

  const EdgeGraph& graph_;
  std::vector<double> distance_;
  std::vector<Index> source_, previous_;
  std::vector<char> wanted_;
  std::vector<Index> touched_;
  std::vector<std::size_t> place_;  ///< where the heap holds a vertex
  Heap heap_;
  std::size_t open_wanted_ = 0;
  double limit_ = std::numeric_limits<double>::infinity();
  std::uint64_t settled_ = 0;
};

}  // namespace geodrome
