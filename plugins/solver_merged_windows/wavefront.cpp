// SPDX-License-Identifier: MIT
#include "plugins/solver_merged_windows/wavefront.hpp"

#include <algorithm>
#include <utility>

#include "plugins/common/exact/least_distance.hpp"
#include "plugins/common/exact/tolerances.hpp"

namespace geodrome::merged_windows {
namespace {

/// About the least L of ordered windows, by which they queue: exact where L changes by at most the way along them.
double nearness(const Window& first, const Window& last) {
  return std::max(0.0, 0.5 * (first.at(first.low) + last.at(last.high) - (last.high - first.low)));
}

bool is_beyond(double limit, double value) { return value * (1 - rounding_share) > limit; }

/// Whether all L of windows are above a limit. Most are told by `near`, without a look at each of them.
bool all_beyond(double limit, double near, std::span<const Window> run) {
  return is_beyond(limit, near) && std::all_of(run.begin(), run.end(), [limit](const Window& w) {
           return is_beyond(limit, least_distance(w, w.low, w.high));
         });
}

}  // namespace

void Wavefront::clear() {
  while (!empty()) {
    for (Index window = pop([](Index) {}).first; window != no_index;)
      pool_.release(std::exchange(window, pool_[window].next));
  }
  queue_.clear();
}

std::size_t Wavefront::push_run(std::span<const Window> run, Index edge, double limit) {
  if (run.empty()) return 0;
  const double near = nearness(run.front(), run.back()), length = surface_.length(edge);
  if (all_beyond(limit, near, run)) return 0;
  std::size_t pushed = 0;
  surface_.for_each_across(edge, [&](Index half_edge, bool mirrored) {
    chain(run, half_edge, mirrored, length);
    queue_.push_half_edge(half_edge, near, length);
    pushed += run.size();
  });
  return pushed;
}

bool Wavefront::push_alone(Index window, const PackedMesh::Across& across, double length, double limit) {
  Window& child = pool_[window];
  const double near = std::max(0.0, least_distance(child, child.low, child.high));
  if (is_beyond(limit, near)) {
    pool_.release(window);
    return false;
  }
  if (across.mirrored) mirror(child, length);
  insert_run(window, window, across.half_edge);
  queue_.push_half_edge(across.half_edge, near, length);
  return true;
}

bool Wavefront::push_two(Index left, Index right, const PackedMesh::Across& across, double length, double limit) {
  const double near = nearness(pool_[left], pool_[right]);
  const auto beyond = [&](Index i) { return is_beyond(limit, least_distance(pool_[i], pool_[i].low, pool_[i].high)); };
  if (is_beyond(limit, near) && beyond(left) && beyond(right)) {
    pool_.release(left), pool_.release(right);
    return false;
  }
  if (across.mirrored) {
    mirror(pool_[left], length), mirror(pool_[right], length);
    std::swap(left, right);
  }
  pool_[left].next = right, pool_[left].ends_run = false;
  insert_run(left, right, across.half_edge);
  queue_.push_half_edge(across.half_edge, near, length);
  return true;
}

void Wavefront::chain(std::span<const Window> run, Index half_edge, bool mirrored, double length) {
  Index first = no_index, last = no_index;
  for (std::size_t i = 0; i < run.size(); ++i) {
    const Index place = pool_.add();
    pool_[place] = run[mirrored ? i : run.size() - 1 - i];
    if (mirrored) mirror(pool_[place], length);
    pool_[place].next = first, pool_[place].ends_run = false;
    first = place;
    if (i == 0) last = place;
  }
  insert_run(first, last, half_edge);
}

/// Inserts windows that are linked where their entry belongs. What came earlier by the same entry is in no order with
/// them, so they become loose.
void Wavefront::insert_run(Index first, Index last, Index half_edge) {
  Index* link = &queue_.first(half_edge);
  if (*link == no_index) {
    pool_[last].next = no_index, pool_[last].ends_run = true;
    *link = first;
    return;
  }
  const auto skip_run = [&] {
    Index end = *link;
    while (!pool_[end].ends_run) end = pool_[end].next;
    link = &pool_[end].next;
  };
  const Entry entry = pool_[first].entry();
  while (*link != no_index && pool_[*link].entry() < entry) skip_run();
  if (*link != no_index && entry != Entry::loose && pool_[*link].entry() == entry) {
    for (Index window = first; window != last; window = pool_[window].next) pool_[window].set_entry(Entry::loose);
    pool_[last].set_entry(Entry::loose);
    while (*link != no_index) skip_run();
  }
  pool_[last].next = *link, pool_[last].ends_run = true;
  *link = first;
}

}  // namespace geodrome::merged_windows
