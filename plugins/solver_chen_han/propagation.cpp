// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/propagation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "plugins/common/exact/close_image.hpp"
#include "plugins/common/exact/image_pair.hpp"
#include "plugins/common/exact/least_distance.hpp"
#include "plugins/common/mesh/prefetch.hpp"

namespace geodrome::chen_han {
namespace {

/// Tells whether the only window of a block is close (close_image.hpp).
bool is_close(const WindowArrays& w, double length) {
  return geodrome::is_close(w.get(0), {w.low()[0], w.high()[0]}, length);
}

PseudoSource image_of(const WindowArrays& w, std::size_t i) {
  return {w.x()[i], w.y()[i], w.sigma()[i], w.names()[i].origin};
}

/// About the least distance of ordered windows, by which they queue: exact where the distance changes by at most the
/// way along them.
double nearness(const Span& list) {
  const WindowArrays& w = list.windows;
  const double low = w.low()[0], high = w.high()[list.count - 1];
  const Register<2> ends = ImagePair(w.get(0), w.get(list.count - 1)).at(both(low, high));
  return std::max(0.0, 0.5 * (ends.v[0] + ends.v[1] - (high - low)));
}

/// Whether all points that windows reach are beyond a limit. Most are told by `near`, without a look at each of them.
bool all_beyond(double limit, double near, const Span& list) {
  const auto beyond = [limit](double distance) { return distance * (1 - rounding_share) > limit; };
  if (!beyond(near)) return false;
  const WindowArrays& w = list.windows;
  for (std::size_t i = 0; i < list.count; ++i)
    if (!beyond(least_distance(w.get(i), w.low()[i], w.high()[i]))) return false;
  return true;
}

}  // namespace

Propagation::Propagation(const PackedMesh& surface, const Settings& settings)
    : VertexPropagation(surface),
      settings_(settings),
      lanes_(&lanes(settings.simd)),
      wavefront_(surface),
      store_(wavefront_.store()),
      trimming_(*lanes_),
      fans_(surface),
      gathering_(surface, store_, fans_, trimming_) {}

void Propagation::begin(bool keep, double limit) {
  wavefront_.clear();  // what a run that was stopped left behind
  VertexPropagation::begin(keep, limit);
  kept_.reset();
  if (keep) kept_.prepare(3 * surface_.face_count());
  trimming_.reset();
  fans_.reset();
  counts_ = {};
  direct_ = nullptr;
  wavefront_.mark_mirrored(0);
}

void Propagation::next() {
  const Wavefront::Next next = wavefront_.pop([this](Index vertex) { prefetch(&labels_[vertex]); });
  if (next.block) {
    const Gathering::Gathered gathered = gathering_.gather(next.element, *next.block);
    if (gathered.list.count > 0) pass(next.element, gathered.list, gathered.depth);
    gathering_.release(*next.block);
  } else {
    direct_ ? go_on_from(next.element) : emit(next.element);
  }
  counts_.trimmed = trimming_.dropped();
}

void Propagation::send_wedge(const Apex& apex, const PseudoSource& from, double, Entry entry) {
  Block& block = store_.add(1);
  block.entry = entry, block.depth = 1;
  block.windows().set(0, {apex.length - from.x, -from.y, from.sigma, 0, apex.length, from.origin, no_index});
  if (direct_) block.windows().names()[0] = DirectRun::names(direct_->first_bearing(apex.left()));
  block.near = nearness(block.span());
  hand_on(block, apex.face, apex.half_edge);
}

/// Carries windows across the face of a half-edge.
void Propagation::pass(Index half_edge, Span list, Index depth) {
  if (surface_.is_copy(half_edge / 3) && !keep_ && watched_.empty()) return;
  const Apex apex(surface_, half_edge);
  filter(list, apex.length, shortest_to(apex.start()), shortest_to(apex.end()));
  if (list.count == 0) return;
  ++counts_.passes;
  counts_.propagated += list.count;
  counts_.longest = std::max<std::uint64_t>(counts_.longest, list.count);
  if (keep_) {
    const Index first = kept_.keep(half_edge, list.windows, list.count);
    for (std::size_t i = 0; i < list.count; ++i) list.windows.names()[i].parent = first + static_cast<Index>(i);
  }
  if (!watched_.empty()) lower_watched(half_edge, list);

  if (surface_.is_copy(half_edge / 3)) return;
  if (depth >= surface_.face_count()) return;  // a shortest path crosses no face twice
  const Parting parting = lanes_->part(list.windows, list.count, apex.x, apex.y);
  if (!parting.in_order) return carry_one_by_one(apex, list, depth + 1);
  const Split split = split_at(apex, list.windows, parting);
  lower_apex(apex, list, split);
  const std::size_t left_end = split.last_left(), right_begin = split.first_right();
  carry(apex, to_left({list.windows, left_end}, split.right_begin),
        to_right({list.windows.without(right_begin), list.count - right_begin},
                 static_cast<std::ptrdiff_t>(split.left_end - right_begin)),
        depth + 1);
}

/// Lowers the apex: by the best window that has a line to it, by the ends of windows that end beside it, and along the
/// edges. A way that bends at the end of a window exists as well; it is what keeps a vertex that lies in the gap
/// between two windows, by rounding or behind a saddle too flat to count as one.
void Propagation::lower_apex(const Apex& apex, const Span& list, const Split& split) {
  const WindowArrays& w = list.windows;
  const double close = close_share * apex.length, label = labels_.distance(apex.vertex());
  const auto matters = [&](double way, double sigma) { return way < label || way - sigma <= close; };
  if (split.covered()) {
    const double way = w.to(split.best, apex.x, apex.y);
    if (matters(way, w.sigma()[split.best])) lower_apex_by(apex, list, split.best, w.x()[split.best], way);
  }
  const std::size_t before = split.covered() ? split.right_begin : split.left_end;
  const std::size_t after = split.covered() ? split.left_end : split.right_begin;
  const std::size_t left = before > 0 ? before - 1 : 0, right = std::min(after, list.count - 1);
  const Register<2> x = both(w.high()[left], w.low()[right]), along = x - Register<2>(apex.x);
  const ImagePair images(w.get(left), w.get(right));
  const Register<2> way = images.at(x) + root(along * along + Register<2>(apex.y * apex.y));
  const auto bent = [&](std::size_t i, double place, double length) {
    if (matters(length, w.sigma()[i]) && may_lower(apex, list, i, length))
      lower_apex_by(apex, list, i, bend_at(w, i, place), length);
  };
  if (before > 0) bent(left, x.v[0], way.v[0]);
  if (after < list.count) bent(right, x.v[1], way.v[1]);
  if (std::min(x.v[0] - w.low()[left], w.high()[right] - x.v[1]) <= close) lower_apex_over(apex, list, before, after);
  lower_along_edges(apex);
}

/// By window i, coming from its image, or from (x, 0) if the way bends there.
void Propagation::lower_apex_by(const Apex& apex, const Span& list, std::size_t i, double x, double distance) {
  const WindowArrays& w = list.windows;
  PseudoSource image = image_of(w, i);
  if (direct_) image.origin = direct_->source();
  lower_apex_from(apex, image, x, distance, [&] {
    if (direct_) note_exit(apex, w, i, x);
    return Step{.window = w.names()[i].parent};
  });
  if (direct_) widen_if_bent_near(apex, x != w.x()[i], x, distance);
}

void Propagation::lower_watched(Index half_edge, const Span& list) {
  for_each_watched(half_edge, [&](Watched& watched, double x, double y) {
    for (std::size_t i = 0; i < list.count; ++i) {
      const double way = way_through(list.windows.get(i), x, y, watched.distance);
      if (way < watched.distance) watched.distance = way, watched.source = source_of(list.windows.names()[i].origin);
    }
  });
}

// ---------------------------------------------------------------------------------------------------------------------
// Across a face

/// Carries windows through the edges to the left and the right of the apex.
void Propagation::carry(const Apex& apex, const Child& left, const Child& right, Index depth) {
  Block *left_block = nullptr, *right_block = nullptr;  // both sides at once, as far as nothing depends on one of them
  if (left.list.count > 0 && !apex.left_is_boundary()) left_block = &carried(left, turn_left(apex), Entry::left, depth);
  if (right.list.count > 0 && !apex.right_is_boundary())
    right_block = &carried(right, turn_right(apex), Entry::right, depth);
  if (direct_ && left_block) direct_->turn(left_block->span(), direct_->angle(apex.half_edge));
  if (direct_ && right_block) direct_->turn(right_block->span(), Bearing{0} - direct_->angle(apex.right()));
  if (left_block) hand_on(*left_block, apex.face, apex.left());
  if (right_block) hand_on(*right_block, apex.face, apex.right());
}

Block& Propagation::carried(const Child& child, const Turn& turn, Entry entry, Index depth) {
  Block& block = store_.add(child.list.count);
  block.entry = entry, block.depth = depth;
  lanes_->carry(child.list.windows, child.list.count, turn, child.clip, block.windows());
  block.near = nearness(block.span());
  return block;
}

/// Lets a block wait at the other half-edges of an edge. Its windows are cut against each other when they are carried
/// on, together with what comes from elsewhere.
void Propagation::hand_on(Block& block, const PackedMesh::Face& face, Index edge) {
  const double length = face.length[edge % 3];
  bool at_once = false;
  if (block.count == 1) {
    if (block.windows().empty(0)) {
      trimming_.drop(1);
      return store_.release(block);
    }
    at_once = is_close(block.windows(), length);
  }
  if (all_beyond(limit_, block.near, block.span())) return store_.release(block);
  const PackedMesh::Across across = PackedMesh::only_across(face, static_cast<int>(edge % 3));
  if (at_once || across.half_edge == no_index || across.mirrored) return hand_on_elsewhere(block, edge, at_once);
  counts_.created += block.count;
  wavefront_.push_block(block, across.half_edge, length);
}

/// Lets a block wait at half-edges that are not one that runs against the edge, or pass it at once.
void Propagation::hand_on_elsewhere(Block& block, Index edge, bool at_once) {
  if (surface_.branches(edge)) return hand_on_claimed(block, edge);
  if (at_once) return pass_at_once(block, edge);
  counts_.created += wavefront_.push_copies(block, edge);
}

/// At an edge of more than two faces only what is nearer than all that came there before goes on.
void Propagation::hand_on_claimed(Block& block, Index edge) {
  Span list = block.span();
  std::vector<Span> parts;
  gathering_.trim(list, parts);
  parts.push_back(list);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Block& part = claimed(parts[i], block, edge);
    if (part.count == 0)
      store_.release(part);
    else if (part.count == 1 && is_close(part.windows(), surface_.length(edge)))
      pass_at_once(part, edge);
    else
      counts_.created += wavefront_.push_copies(part, edge);
  }
  store_.release(block);
}

/// A block of what of some windows of a block is nearer than all that came to an edge before.
Block& Propagation::claimed(const Span& windows, const Block& block, Index edge) {
  const WindowList& parts = fans_.claim(edge, windows.windows, windows.count);
  Block& rest = store_.add(parts.size());
  copy_windows(parts.arrays(), parts.size(), rest.windows());
  rest.entry = block.entry, rest.depth = block.depth, rest.near = block.near;
  return rest;
}

void Propagation::pass_at_once(Block& block, Index edge) {
  if (left_to_end(image_of(block.windows(), 0), edge)) return store_.release(block);
  surface_.for_each_across(edge, [&](Index half_edge, bool mirrored) {
    Block& own = wavefront_.copy_of(block, mirrored, surface_.length(edge));
    ++counts_.created;
    pass(half_edge, own.span(), own.depth);
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
  const auto start_is_nearer = [&](double way, std::size_t i) { return longer(way, at_start + w.high()[i]); };
  const auto end_is_nearer = [&](double way, std::size_t i) { return longer(way, at_end + (length - w.low()[i])); };
  const Register<2> ways = ImagePair(w.get(0), w.get(last - 1)).at(both(w.high()[0], w.low()[last - 1]));
  if (start_is_nearer(ways.v[0], 0)) do
      ++first;
    while (first < last && start_is_nearer(w.at(first, w.high()[first]), first));
  if (first < last && end_is_nearer(ways.v[1], last - 1)) do
      --last;
    while (first < last && end_is_nearer(w.at(last - 1, w.low()[last - 1]), last - 1));
  counts_.filtered += list.count - (last - first);
  list = {w.without(first), last - first};
}

}  // namespace geodrome::chen_han
