// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/propagation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "plugins/common/exact/bisector.hpp"
#include "plugins/common/mesh/prefetch.hpp"

namespace geodrome::chen_han {
namespace {

/// Whether the image is close to the half-edge, between the ends of its window: all its lines cross at nearly one
/// place, which rounding does not tell apart any more. Such a window goes on at once and alone, so that its lines are
/// not cut by places on that half-edge. (On faces without area the image lies on the half-edge.)
bool is_close(const WindowArrays& w, double length) {
  return -w.y[0] <= close_share * length && w.low[0] < w.x[0] && w.x[0] < w.high[0];
}

}  // namespace

Propagation::Propagation(const PackedMesh& surface, const Settings& settings)
    : VertexPropagation(surface),
      settings_(settings),
      lanes_(&lanes(Simd::baseline)),
      wavefront_(surface),
      store_(wavefront_.store()),
      trimming_(*lanes_),
      fans_(surface) {}

void Propagation::begin(bool keep, double limit) {
  wavefront_.clear();  // what a run that was stopped left behind
  VertexPropagation::begin(keep, limit);
  kept_.reset();
  if (keep) kept_.prepare(3 * surface_.face_count());
  trimming_.reset();
  fans_.reset();
  counts_ = {};
  choose_lanes();
}

/// Wide registers for a run whose lists are long so far, since the processor lowers its clock for them.
void Propagation::choose_lanes() {
  constexpr std::uint64_t long_list = 7;
  lanes_ = &lanes(counts_.propagated > long_list * counts_.passes ? settings_.simd : Simd::baseline);
  trimming_.use(*lanes_);
}

void Propagation::next() {
  const Wavefront::Next next = wavefront_.pop([this](Index vertex) { prefetch(&labels_[vertex]); });
  if (next.vertex != no_index)
    emit(next.vertex);
  else
    process(next.half_edge, next.block);
  counts_.trimmed = trimming_.dropped();
}

void Propagation::send_wedge(const Apex& apex, const PseudoSource& from, double, Entry entry) {
  const Index block = store_.add(1);
  Block& b = store_[block];
  b.entry = entry, b.depth = 1;
  b.windows().set(0, {apex.length - from.x, -from.y, from.sigma, 0, apex.length, from.origin, no_index});
  b.windows().pad(1);
  hand_on(block, apex.half_edge);
}

/// Carries on what waits at a half-edge, as one list.
void Propagation::process(Index half_edge, Index block) {
  if (store_[block].next != no_index || surface_.branches(half_edge)) return gather(half_edge, block);
  pass(half_edge, {store_[block].windows(), store_[block].count}, store_[block].depth);
  store_.release(block);
}

/// Several blocks, or windows that something nearer may have come to since: one of each entry in their order, the
/// others merged into them.
void Propagation::gather(Index half_edge, Index first_block) {
  std::array<Index, 3> ordered{no_index, no_index, no_index};
  blocks_.clear();
  Index depth = no_index;
  for (Index b = first_block; b != no_index; b = store_[b].next) {
    depth = std::min(depth, store_[b].depth);
    const Entry entry = store_[b].entry;
    if (entry == Entry::loose || ordered[static_cast<std::size_t>(entry)] != no_index)
      blocks_.push_back(b);
    else
      ordered[static_cast<std::size_t>(entry)] = b;
  }
  list_.clear();
  for (const Index b : ordered) {
    if (b == no_index) continue;
    if (trimming_.append(list_, store_[b].windows(), store_[b].count))
      store_.release(b);
    else
      blocks_.push_back(b);
  }
  for (const Index b : blocks_) {
    trimming_.merge(list_, store_[b].windows(), store_[b].count);
    store_.release(b);
  }
  if (surface_.branches(half_edge)) fans_.keep_nearest(half_edge, list_);
  if (list_.empty()) return;
  list_.arrays().pad(list_.size());
  pass(half_edge, {list_.arrays(), list_.size()}, depth);
}

/// Carries windows across the face of a half-edge.
void Propagation::pass(Index half_edge, Span list, Index depth) {
  if (surface_.is_copy(half_edge / 3) && !keep_ && watched_.empty()) return;
  const Apex apex(surface_, half_edge);
  filter(list, apex.length, labels_.distance(apex.start()), labels_.distance(apex.end()));
  if (list.count == 0) return;
  ++counts_.passes;
  counts_.propagated += list.count;
  counts_.longest = std::max<std::uint64_t>(counts_.longest, list.count);
  if (keep_) {
    const Index first = kept_.keep(half_edge, list.windows, list.count);
    for (std::size_t i = 0; i < list.count; ++i) list.windows.parent[i] = first + static_cast<Index>(i);
  }
  if (!watched_.empty()) lower_watched(half_edge, list);

  if (surface_.is_copy(half_edge / 3)) return;
  if (depth >= surface_.face_count()) return;  // a shortest path crosses no face twice
  const Parting parting = lanes_->part(list.windows, list.count, apex.x, apex.y);
  if (!parting.in_order) return carry_one_by_one(apex, list, depth + 1);
  const Split split = split_at(apex, list.windows, parting);
  lower_apex(apex, list, split);
  carry_left(apex, list, split.last_left(), split.right_begin, depth + 1);
  carry_right(apex, list, split.first_right(), split.left_end, depth + 1);
}

/// Windows whose lines cross beyond the half-edge, so that they do not lie to the left and right of the apex in order.
void Propagation::carry_one_by_one(const Apex& apex, const Span& list, Index depth) {
  const WindowArrays& w = list.windows;
  const auto both = [&](std::size_t i) { return has_left(apex, w, i) && has_right(apex, w, i); };
  std::size_t best = list.count;
  for (std::size_t i = 0; i < list.count; ++i) {
    const double x = both(i) ? w.x[i] : has_left(apex, w, i) ? w.high[i] : w.low[i];
    lower_apex_by(apex, list, i, x, way_through(w.get(i), apex.x, apex.y, labels_.distance(apex.vertex())));
    if (both(i) && (best == list.count || w.to(i, apex.x, apex.y) < w.to(best, apex.x, apex.y))) best = i;
  }
  const auto keeps_both = [&](std::size_t i) {
    return w.to(i, apex.x, apex.y) <= w.to(best, apex.x, apex.y) * (1 + equal_share);
  };
  const auto choose = [&](auto&& goes) {
    chosen_.clear();
    for (std::size_t i = 0; i < list.count; ++i)
      if (goes(i)) chosen_.push(w.get(i));
    if (!chosen_.empty()) chosen_.arrays().pad(chosen_.size());
    return Span{chosen_.arrays(), chosen_.size()};
  };
  const Span left =
      choose([&](std::size_t i) { return has_left(apex, w, i) && (!both(i) || i <= best || keeps_both(i)); });
  carry_left(apex, left, left.count, left.count, depth);
  const Span right =
      choose([&](std::size_t i) { return has_right(apex, w, i) && (!both(i) || i >= best || keeps_both(i)); });
  carry_right(apex, right, 0, 0, depth);
}

/// Lowers the apex: by the best window that has a line to it, by the ends of windows that end beside it, and along the
/// edges. A way that bends at the end of a window exists as well; it is what keeps a vertex that lies in the gap
/// between two windows, by rounding or behind a saddle too flat to count as one.
void Propagation::lower_apex(const Apex& apex, const Span& list, const Split& split) {
  const WindowArrays& w = list.windows;
  const auto bent = [&](std::size_t i, double x) {
    lower_apex_by(apex, list, i, x, w.at(i, x) + std::sqrt((apex.x - x) * (apex.x - x) + apex.y * apex.y));
  };
  if (split.covered()) lower_apex_by(apex, list, split.best, w.x[split.best], w.to(split.best, apex.x, apex.y));
  const std::size_t before = split.covered() ? split.right_begin : split.left_end;
  const std::size_t after = split.covered() ? split.left_end : split.right_begin;
  if (before > 0) bent(before - 1, w.high[before - 1]);
  if (after < list.count) bent(after, w.low[after]);
  lower_along_edges(apex);
}

/// By window i, coming from its image, or from (x, 0) if the way bends there.
void Propagation::lower_apex_by(const Apex& apex, const Span& list, std::size_t i, double x, double distance) {
  const WindowArrays& w = list.windows;
  const PseudoSource image{w.x[i], w.y[i], w.sigma[i], w.origin[i]};
  lower_apex_from(apex, image, x, distance, [&] { return Step{.window = w.parent[i]}; });
}

void Propagation::lower_watched(Index half_edge, const Span& list) {
  for_each_watched(half_edge, [&](Watched& watched, double x, double y) {
    for (std::size_t i = 0; i < list.count; ++i) {
      const double way = way_through(list.windows.get(i), x, y, watched.distance);
      if (way < watched.distance) watched.distance = way, watched.source = source_of(list.windows.origin[i]);
    }
  });
}

// ---------------------------------------------------------------------------------------------------------------------
// Across a face

/// The lines to the left of the apex, of the first `end` windows; those from `clipped` on also have lines to the apex,
/// or beyond it.
void Propagation::carry_left(const Apex& apex, const Span& list, std::size_t end, std::size_t clipped, Index depth) {
  if (end == 0 || apex.left_is_boundary()) return;
  const Index block = carry({list.windows, end}, turn_left(apex));
  const WindowArrays child = store_[block].windows();
  for (std::size_t i = clipped; i < end; ++i) child.high[i] = apex.left_length();
  send(block, apex.left(), Entry::left, depth);
}

/// The lines to the right of the apex, of the windows from `begin` on; those before `clipped` also have lines to the
/// apex, or beyond it.
void Propagation::carry_right(const Apex& apex, const Span& list, std::size_t begin, std::size_t clipped, Index depth) {
  if (begin == list.count || apex.right_is_boundary()) return;
  const Index block = carry({list.windows.without(begin), list.count - begin}, turn_right(apex));
  const WindowArrays child = store_[block].windows();
  for (std::size_t i = begin; i < clipped; ++i) child.low[i - begin] = 0;
  send(block, apex.right(), Entry::right, depth);
}

/// A block with the windows as seen from another edge.
Index Propagation::carry(const Span& list, const Turn& turn) {
  const Index block = store_.add(list.count);
  lanes_->carry(list.windows, list.count, turn, store_[block].windows());
  return block;
}

/// Trims a block of windows that left a face through half-edge `edge`, in the frame of the other side, and hands on
/// what is left of it.
void Propagation::send(Index block, Index edge, Entry entry, Index depth) {
  Block& b = store_[block];
  b.entry = entry, b.depth = depth;
  const WindowArrays windows = b.windows();
  windows.pad(b.count);
  b.count = static_cast<std::uint32_t>(trimming_.trim(windows, b.count, breaks_));
  if (!breaks_.empty()) split_off(block, edge);
  hand_on(block, edge);
}

/// What is behind a break of a block waits as a block of its own.
void Propagation::split_off(Index block, Index edge) {
  const std::vector<std::uint32_t> breaks(breaks_.rbegin(), breaks_.rend());  // handing on may trim, with breaks_
  for (const std::uint32_t first : breaks) {
    const Index rest = store_.add(store_[block].count - first);
    copy_windows(store_[block].windows().without(first), store_[rest].count, store_[rest].windows());
    store_[rest].windows().pad(store_[rest].count);
    store_[rest].entry = store_[block].entry, store_[rest].depth = store_[block].depth;
    store_[block].count = first;
    hand_on(rest, edge);
  }
}

/// Leaves of a block at an edge of more than two faces what is nearer than all that came there before.
Index Propagation::claim(Index block, Index edge) {
  const WindowList& parts = fans_.claim(edge, store_[block].windows(), store_[block].count);
  const Index rest = store_.add(parts.size());
  copy_windows(parts.arrays(), parts.size(), store_[rest].windows());
  if (!parts.empty()) store_[rest].windows().pad(parts.size());
  store_[rest].entry = store_[block].entry, store_[rest].depth = store_[block].depth;
  store_.release(block);
  return rest;
}

/// Lets a block wait at the other half-edges of an edge.
void Propagation::hand_on(Index block, Index edge) {
  if (surface_.branches(edge)) block = claim(block, edge);
  if (store_[block].count != 1 || !is_close(store_[block].windows(), surface_.length(edge))) {
    counts_.created += wavefront_.push_block(block, edge, limit_);
    return;
  }
  surface_.for_each_across(edge, [&](Index half_edge, bool mirrored) {
    const Index own = wavefront_.copy_of(block, mirrored, surface_.length(edge));
    ++counts_.created;
    pass(half_edge, {store_[own].windows(), 1}, store_[own].depth);
    store_.release(own);
  });
  store_.release(block);
}

/// Xin and Wang's filter, and the trimming that follows from it: |image x| - x falls along the half-edge, so where the
/// way over its start is shorter at x it is shorter at everything before x too; likewise at the end.
void Propagation::filter(Span& list, double length, double at_start, double at_end) {
  if (!settings_.filter) return;
  const WindowArrays& w = list.windows;
  std::size_t first = 0, last = list.count;
  const auto longer = [](double way, double other) { return way > other + rounding_share * way; };
  while (first < last && longer(w.at(first, w.high[first]), at_start + w.high[first])) ++first;
  while (first < last && longer(w.at(last - 1, w.low[last - 1]), at_end + (length - w.low[last - 1]))) --last;
  counts_.filtered += list.count - (last - first);
  list = {w.without(first), last - first};
}

}  // namespace geodrome::chen_han
