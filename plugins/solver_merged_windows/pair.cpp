// SPDX-License-Identifier: MIT
// How two windows of a half-edge are carried across its face: what lists do for any number of them, but in registers.
// On smooth surfaces a third to a half of all passes begin with two.
#include "plugins/solver_merged_windows/pair.hpp"
#include "plugins/common/exact/turn.hpp"
#include "plugins/solver_merged_windows/propagation.hpp"

namespace geodrome::merged_windows {

/// What `gather` does for two windows, the whole chain of a half-edge. False if they have to be merged into a list;
/// nothing is done then.
bool Propagation::process_two(Index half_edge, Index first, Index second) {
  WindowPool& pool = wavefront_.pool();
  std::array<Window, 2> windows{pool[first], pool[second]};
  auto& [left, right] = windows;
  if (right.entry() == Entry::loose) return false;
  const Remains remains = left.ends_run ? trimming_.settle(left, right) : Remains::both;
  if (remains == Remains::unsettled) return false;
  pool.release(first), pool.release(second);
  if (remains == Remains::both)
    pass_two(half_edge, windows);
  else if (remains != Remains::none)
    pass_alone(half_edge, remains == Remains::left ? left : right);
  return true;
}

/// What `pass` does, for two windows in order of which nothing is to be kept.
void Propagation::pass_two(Index half_edge, std::array<Window, 2>& windows) {
  auto& [left, right] = windows;
  const Apex apex(surface_, half_edge);
  const Pair pair(left, right);
  const Merging::Seam seam(pair);
  const Two over_ends =
      both(labels_.distance(apex.start()) + left.high, labels_.distance(apex.end()) + (apex.length - right.low));
  if (Two::any(seam.l > over_ends + Two(rounding_share) * seam.l)) {  // `filter` drops one at least
    list_.assign({left, right});
    return pass(half_edge);
  }
  ++counts_.passes;
  if (may_join(left, right) && !merging_.is_hopeless(left, right, apex.length, seam) &&
      merging_.merge_two(windows, {apex.length, sine_below(half_edge)}, seam)) {
    ++counts_.propagated;
    return cross_alone(apex, left);
  }
  counts_.propagated += 2;
  counts_.longest = std::max<std::uint64_t>(counts_.longest, 2);
  cross_two(apex, left, right, pair);
}

/// What `cross` does for two windows, if the apex lies to the left or right of all their lines, between them, or among
/// those of one.
void Propagation::cross_two(const Apex& apex, const Window& left, const Window& right, const Pair& pair) {
  const Two low_side = side_of_line(pair.x, pair.y, pair.low, apex.x, apex.y);
  const Two high_side = side_of_line(pair.x, pair.y, pair.high, apex.x, apex.y);
  const bool left_to_left = low_side.v[0] < 0, right_to_left = low_side.v[1] < 0;
  const bool left_to_right = high_side.v[0] > 0, right_to_right = high_side.v[1] > 0;
  const bool none = !(left_to_left || left_to_right) || !(right_to_left || right_to_right);
  if (none || (left_to_right && (right_to_left || !right_to_right)) || (right_to_left && !left_to_left)) {
    list_.assign({left, right});
    return cross(apex);
  }
  if (right_to_left && right_to_right)
    lower_apex_straight(apex, right), lower_apex_bent(apex, left, left.high);
  else if (left_to_left && left_to_right)
    lower_apex_straight(apex, left), lower_apex_bent(apex, right, right.low);
  else {
    if (left_to_left) lower_apex_bent(apex, right_to_left ? right : left, right_to_left ? right.high : left.high);
    if (right_to_right) lower_apex_bent(apex, left_to_right ? left : right, left_to_right ? left.low : right.low);
  }
  lower_along_edges(apex);

  WindowPool& pool = wavefront_.pool();
  if (left_to_left && !apex.left_is_boundary()) {
    if (right_to_left) {
      const Index first = pool.add(), second = pool.add();
      carry_left(apex, left, false, pool[first]), carry_left(apex, right, right_to_right, pool[second]);
      send_two(first, second, apex, apex.c);
    } else {
      send_left(apex, left, left_to_right);
    }
  }
  if (right_to_right && !apex.right_is_boundary()) {
    if (left_to_right) {
      const Index first = pool.add(), second = pool.add();
      carry_right(apex, left, left_to_left, pool[first]), carry_right(apex, right, false, pool[second]);
      send_two(first, second, apex, apex.b);
    } else {
      send_right(apex, right, right_to_left);
    }
  }
}

/// What `send` and `hand_on` do, for two windows, which stand in the pool, that left through edge i of the face.
void Propagation::send_two(Index left, Index right, const Apex& apex, int i) {
  WindowPool& pool = wavefront_.pool();
  const PackedMesh::Across across = PackedMesh::only_across(apex.face, i);
  const double length = apex.face.length[i];
  switch (across.half_edge == no_index ? Remains::unsettled : trimming_.settle(pool[left], pool[right])) {
    case Remains::none:
      return pool.release(left), pool.release(right);
    case Remains::left:
      pool.release(right);
      return hand_on_alone(left, apex, i);
    case Remains::right:
      pool.release(left);
      return hand_on_alone(right, apex, i);
    case Remains::both:
      if (wavefront_.push_two(left, right, across, length, limit_)) counts_.created += 2;
      return;
    case Remains::unsettled:
      child_.assign({pool[left], pool[right]});
      pool.release(left), pool.release(right);
      send(apex.half_edge / 3 * 3 + static_cast<Index>(i));
  }
}

}  // namespace geodrome::merged_windows
