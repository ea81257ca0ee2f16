// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geodrome/run_context.hpp"
#include "plugins/common/mesh/bucket_queue.hpp"
#include "plugins/common/mesh/prefetch.hpp"
#include "plugins/solver_chen_han/rows/direct_list.hpp"

namespace geodrome::chen_han {

/// Distances of all vertices from one, by Dijkstra's algorithm over lists of direct paths: where a vertex is settled at
/// which paths can bend, it is gone on from by those of its paths that leave in a direction a shortest path can take.
class RowLabels {
 public:
  struct Counts {
    std::uint64_t settled = 0;  ///< vertices whose list was looked at, each time
    std::uint64_t relaxed = 0;  ///< direct paths that were tried
  };

  /// `lists`, which are complete, are kept by reference.
  explicit RowLabels(const std::vector<DirectList>& lists);

  /// Forgets the last run, even one that was stopped, and starts at a source, at a distance, with its list, or with the
  /// direct paths that a search found from it. O(what the last run touched + paths).
  void begin(Index source, double distance);
  void begin(Index source, double distance, std::span<const FoundPath> paths);
  /// Goes on from all vertices up to a limit. `lower_limit()` is called once in `steps_a_poll` steps, and its result
  /// becomes the limit if it is lower. Throws Cancelled.
  template <class LowerLimit>
  void run(double limit, const RunContext& context, LowerLimit&& lower_limit) {
    for (std::size_t step = 0; !queue_.empty(); ++step) {
      if (step % steps_a_poll == 0) context.throw_if_cancelled();
      if (step % steps_a_poll == steps_a_poll - 1) limit = std::min(limit, lower_limit());
      const BucketQueue::Entry next = queue_.pop();
      Label& label = labels_[next.element];
      if (next.key != label.key) continue;
      label.key = not_waiting;
      if (label.distance <= limit) go_on(next.element);
    }
  }
  static constexpr std::size_t steps_a_poll = 256;

  double distance(Index vertex) const { return labels_[vertex].distance; }
  /// Returns the vertices that were reached, each once, in any order.
  const std::vector<Index>& reached() const { return reached_; }
  const Counts& counts() const { return counts_; }
  std::size_t bytes() const {
    return labels_.size() * (sizeof(Label) + sizeof(directed_[0])) + reached_.capacity() * sizeof(Index) +
           queue_.bytes();
  }

 private:
  static constexpr float not_waiting = std::numeric_limits<float>::infinity();

  struct Label {
    double distance = infinity;
    float key = not_waiting;  ///< of the entry in the queue that counts
    Onward onward;
  };

  void forget();
  void go_on(Index vertex);
  void relax(double distance, std::span<const DirectPath> paths);
  void relax_any(double distance, std::span<const DirectPath> paths);
  void set(Index vertex, double distance, Onward onward);
  void wait(Index vertex);

  const std::vector<DirectList>& lists_;
  std::vector<const DirectPath*> directed_;  ///< of the lists, so that they can be fetched without a look at them
  std::vector<Label> labels_;
  std::vector<Index> reached_;
  BucketQueue queue_;
  Counts counts_;
};

}  // namespace geodrome::chen_han
