// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/solver_schreiber/front.hpp"

namespace geodrome::schreiber {

/// The next step of a path from a vertex towards its source: across a half-edge, along an edge to another vertex, or,
/// if neither is set, straight to the source.
struct Step {
  double crossing = 0;  ///< place on the half-edge, in its frame
  Index half_edge = no_index, vertex = no_index;
  Index front = no_index;   ///< number of the kept front that crosses there
  Index origin = no_index;  ///< of its generator
};

/// The path to a point through a generator: its length and where it crosses the half-edge.
struct Crossing {
  double distance, place;
};
/// Returns the path to a point through a generator, straight or bent at the end of its claim of the half-edge.
/// `distance` is some value >= `best` if no path shorter than that exists.
Crossing way_through(const Generator& g, double length, double px, double py, double best);

/// The shortest-path map: the fronts that were carried on, by half-edge. Fronts share their nodes.
class KeptFronts {
 public:
  /// A path to a point through a kept front.
  struct Way {
    double distance = infinity;
    Index source = no_index;
    Step step;
  };

  void reset() {
    for (const Kept& kept : kept_) last_[kept.half_edge] = no_index;
    kept_.clear();
  }
  /// Makes room for fronts. Precondition of `keep` and `for_each`. O(half-edges) the first time.
  void prepare(std::size_t half_edge_count) { last_.resize(half_edge_count, no_index); }

  /// Keeps a front. Fronts are numbered in the order in which they are kept: a front has a higher number than the front
  /// it came from.
  void keep(Index half_edge, const Front& front) {
    kept_.push_back({front, half_edge, last_[half_edge]});
    last_[half_edge] = static_cast<Index>(kept_.size() - 1);
  }

  /// Returns the number of the last front kept, no_index if there is none.
  Index last() const { return static_cast<Index>(kept_.size()) - 1; }

  /// Calls `visit(front, number)` for the fronts kept at a half-edge with numbers below `end`, the latest first.
  template <class Visit>
  void for_each(Index half_edge, Index end, Visit&& visit) const {
    if (last_.empty()) return;
    for (Index k = last_[half_edge]; k != no_index; k = kept_[k].before)
      if (k < end) visit(kept_[k].front, k);
  }

  std::size_t bytes() const { return kept_.capacity() * sizeof(Kept) + last_.capacity() * sizeof(Index); }

 private:
  struct Kept {
    Front front;
    Index half_edge, before;  ///< the one before at the same half-edge
  };
  std::vector<Kept> kept_;
  std::vector<Index> last_;
};

}  // namespace geodrome::schreiber
