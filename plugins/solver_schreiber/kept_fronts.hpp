// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <vector>

#include "plugins/common/mesh/packed_mesh.hpp"
#include "plugins/solver_schreiber/front.hpp"

namespace geodrome::schreiber {

/// How a path goes on from a vertex: across a half-edge, along an edge to another vertex, or (neither)
/// straight to its source.
struct Step {
  double crossing = 0;  ///< place on the half-edge, in its frame
  Index half_edge = no_index, vertex = no_index;
  Index front = no_index;   ///< number of the kept front that crosses there
  Index origin = no_index;  ///< of its generator
};

/// The way to a point through a front, straight or bent at the end of what a generator has of the half-edge: `distance`
/// of an image that is not less than `best` may be anything that is not.
struct Crossing {
  double distance, place;
};
Crossing way_through(const Generator& g, double length, double px, double py, double best);

/// The fronts that were carried on, by half-edge: the shortest-path map. They share their nodes.
class KeptFronts {
 public:
  /// A way to a point through a kept front.
  struct Way {
    double distance = std::numeric_limits<double>::infinity();
    Index source = no_index;
    Step step;
  };

  void reset() {
    for (const Kept& kept : kept_) last_[kept.half_edge] = no_index;
    kept_.clear();
  }
  /// Called before the first `keep` and `for_each`. O(half-edges) the first time.
  void prepare(std::size_t half_edge_count) { last_.resize(half_edge_count, no_index); }

  /// Fronts are numbered in the order in which they are kept: what a front came from has a lower number.
  void keep(Index half_edge, const Front& front) {
    kept_.push_back({front, half_edge, last_[half_edge]});
    last_[half_edge] = static_cast<Index>(kept_.size() - 1);
  }

  /// Number of the last one kept, no_index if there is none.
  Index last() const { return static_cast<Index>(kept_.size()) - 1; }

  /// Visits the fronts at a half-edge with numbers below `end`, and these numbers.
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
