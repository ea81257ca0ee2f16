// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/wavefront.hpp"

#include <algorithm>
#include <utility>

#include "plugins/common/exact/least_distance.hpp"
#include "plugins/common/exact/tolerances.hpp"
#include "plugins/common/mesh/prefetch.hpp"

namespace geodrome::chen_han {
namespace {

/// About the least distance of ordered windows, by which they queue: exact where the distance changes by at most the
/// way along them.
double nearness(const WindowArrays& w, std::size_t count) {
  const double width = w.high[count - 1] - w.low[0];
  return std::max(0.0, 0.5 * (w.at(0, w.low[0]) + w.at(count - 1, w.high[count - 1]) - width));
}

/// Whether all points that windows reach are beyond a limit. Most are told by `near`, without a look at each of them.
bool all_beyond(double limit, double near, const WindowArrays& w, std::size_t count) {
  const auto beyond = [limit](double distance) { return distance * (1 - rounding_share) > limit; };
  if (!beyond(near)) return false;
  for (std::size_t i = 0; i < count; ++i)
    if (!beyond(least_distance(w.get(i), w.low[i], w.high[i]))) return false;
  return true;
}

}  // namespace

void Wavefront::clear() {
  while (!empty()) {
    for (Index block = pop([](Index) {}).block; block != no_index;) {
      const Index following = store_[block].next;
      store_.release(block);
      block = following;
    }
  }
  queue_.clear();
}

Wavefront::Next Wavefront::taken(Index element) {
  --waiting_;
  const Slot slot = std::exchange(slots_[element], {});
  if (element >= half_edges_) return {no_index, no_index, element - half_edges_};
  return {element, slot.block, no_index};
}

std::size_t Wavefront::push_block(Index block, Index edge, double limit) {
  const std::size_t count = store_[block].count;
  std::size_t pushed = 0;
  if (count > 0) {
    const double near = nearness(store_[block].windows(), count), length = surface_.length(edge);
    bool is_mirrored = false;
    if (surface_.is_fan(edge))
      store_[block].entry = Entry::loose;  // windows of other faces come to the same half-edges
    const auto wait_at = [&](Index half_edge, bool mirrored) {
      Index own = block;
      if (pushed > 0 || mirrored) own = copy_of(block, mirrored != is_mirrored, length);
      if (pushed == 0 && mirrored) store_.release(std::exchange(block, own)), is_mirrored = true;
      pushed += count;
      store_[own].next = std::exchange(slots_[half_edge].block, own);
      wait(half_edge, key_of(near + patience * length));
    };
    if (!all_beyond(limit, near, store_[block].windows(), count)) surface_.for_each_across(edge, wait_at);
  }
  if (pushed == 0) store_.release(block);
  return pushed;
}

/// Seen from a half-edge that runs the same way as the edge, everything is mirrored.
Index Wavefront::copy_of(Index block, bool mirrored, double length) {
  const std::uint32_t count = store_[block].count;
  const Index copy = store_.add(count);
  const WindowArrays from = store_[block].windows(), to = store_[copy].windows();
  store_[copy].depth = store_[block].depth;
  store_[copy].entry = mirrored ? geodrome::mirrored(store_[block].entry) : store_[block].entry;
  if (!mirrored) {
    copy_windows(from, count, to);
  } else {
    for (std::size_t i = 0; i < count; ++i) {
      const Window w = from.get(i);
      to.set(count - 1 - i, {length - w.x, w.y, w.sigma, length - w.high, length - w.low, w.origin, w.parent});
    }
  }
  to.pad(count);
  return copy;
}

}  // namespace geodrome::chen_han
