// SPDX-License-Identifier: MIT
// How windows of a half-edge cross its face.
#include <algorithm>
#include <cmath>
#include <utility>

#include "plugins/common/exact/bisector.hpp"
#include "plugins/common/exact/close_image.hpp"
#include "plugins/common/exact/turn.hpp"
#include "plugins/solver_merged_windows/propagation.hpp"

namespace geodrome::merged_windows {
namespace {

bool has_left(const Apex& apex, const Window& w) { return side_of_line(w.x, w.y, w.low, apex.x, apex.y) < 0; }
bool has_right(const Apex& apex, const Window& w) { return side_of_line(w.x, w.y, w.high, apex.x, apex.y) > 0; }

}  // namespace

/// What `pass` does, for a single window of which nothing is to be kept: most windows are alone.
void Propagation::pass_alone(Index half_edge, const Window& window) {
  const Apex apex(surface_, half_edge);
  if (is_needless(window, apex)) {
    ++counts_.filtered;
    return;
  }
  ++counts_.passes, ++counts_.propagated;
  cross_alone(apex, window);
}

/// Whether the filter drops all of a window. (Squares are compared in place of roots.)
bool Propagation::is_needless(const Window& w, const Apex& apex) const {
  const double over_start = labels_.distance(apex.start()) + w.high;
  const double over_end = labels_.distance(apex.end()) + (apex.length - w.low);
  const auto longer = [&](double place, double other) {
    const double rest = other * (1 + rounding_share) - w.sigma;
    return rest < 0 || (place - w.x) * (place - w.x) + w.y * w.y > rest * rest;
  };
  return longer(w.high, over_start) || longer(w.low, over_end);
}

void Propagation::cross_alone(const Apex& apex, const Window& window) {
  const bool left = has_left(apex, window), right = has_right(apex, window);
  if (left && right)
    lower_apex_straight(apex, window);
  else
    lower_apex_bent(apex, window, left ? window.high : window.low);
  lower_along_edges(apex);
  if (left && !apex.left_is_boundary()) send_left(apex, window, right);
  if (right && !apex.right_is_boundary()) send_right(apex, window, left);
}

void Propagation::cross(const Apex& apex) {
  const Split split = split_at(apex);
  if (!split.in_order) return carry_one_by_one(apex);
  lower_apex(apex, split);
  const std::span<const Window> list(list_);
  carry_left(apex, list.first(split.covered() ? split.last_best : split.left_end), split.right_begin);
  const std::size_t first_right = split.covered() ? split.first_best : split.right_begin;
  carry_right(apex, list.subspan(first_right), split.left_end - std::min(split.left_end, first_right));
}

/// Parts the list by the lines to the apex. Windows whose lines cross beyond the half-edge may not lie to the left and
/// right of it in order.
Propagation::Split Propagation::split_at(const Apex& apex) const {
  const std::size_t count = list_.size();
  Split split{count, 0, 0, 0, 0, true};
  for (std::size_t i = 0; i < count; ++i) {
    const bool left = has_left(apex, list_[i]), right = has_right(apex, list_[i]);
    if (right && split.right_begin == count) split.right_begin = i;
    if (!right && split.right_begin < count) split.in_order = false;
    if (left && split.left_end != i) split.in_order = false;
    if (left) split.left_end = i + 1;
  }
  if (!split.in_order || !split.covered()) return split;
  const auto value = [&](std::size_t i) { return list_[i].to(apex.x, apex.y); };
  double lowest = infinity;
  for (std::size_t i = split.right_begin; i < split.left_end; ++i)
    if (const double l = value(i); l < lowest) lowest = l, split.best = i;
  split.first_best = split.best, split.last_best = split.best + 1;
  if (split.left_end - split.right_begin == 1) return split;
  while (split.first_best > split.right_begin && value(split.first_best - 1) <= lowest * (1 + equal_share))
    --split.first_best;
  while (split.last_best < split.left_end && value(split.last_best) <= lowest * (1 + equal_share)) ++split.last_best;
  return split;
}

/// Lowers the apex: by the best window that has a line to it, by the ends of windows that end beside it, and along the
/// edges. A way that bends at the end of a window exists as well; it is what keeps a vertex that lies in the gap
/// between two windows, by rounding or behind a saddle too flat to count as one.
void Propagation::lower_apex(const Apex& apex, const Split& split) {
  if (split.covered()) lower_apex_straight(apex, list_[split.best]);
  const std::size_t before = split.covered() ? split.right_begin : split.left_end;
  const std::size_t after = split.covered() ? split.left_end : split.right_begin;
  if (before > 0) lower_apex_bent(apex, list_[before - 1], list_[before - 1].high);
  if (after < list_.size()) lower_apex_bent(apex, list_[after], list_[after].low);
  lower_along_edges(apex);
}

void Propagation::lower_apex_straight(const Apex& apex, const Window& window) {
  lower_apex_by(apex, window, window.x, window.to(apex.x, apex.y));
}

void Propagation::lower_apex_bent(const Apex& apex, const Window& window, double x) {
  lower_apex_by(apex, window, x, window.at(x) + std::sqrt((apex.x - x) * (apex.x - x) + apex.y * apex.y));
}

void Propagation::lower_apex_by(const Apex& apex, const Window& window, double x, double value) {
  const double upper = value + window.slack;
  if (upper < upper_[apex.vertex()].distance)
    upper_.offer(apex.vertex(), {upper, source_of(window.origin)}, {.window = window.parent});
  const PseudoSource image{window.x, window.y, window.sigma, window.origin};
  lower_apex_from(apex, image, x, value, [] { return LabelStep{}; });
}

void Propagation::carry_one_by_one(const Apex& apex) {
  const auto both = [&](const Window& w) { return has_left(apex, w) && has_right(apex, w); };
  double lowest = infinity;
  std::size_t best = list_.size();
  for (std::size_t i = 0; i < list_.size(); ++i) {
    const Window& window = list_[i];
    if (!both(window)) {
      lower_apex_bent(apex, window, has_left(apex, window) ? window.high : window.low);
      continue;
    }
    lower_apex_straight(apex, window);
    if (const double l = window.to(apex.x, apex.y); l < lowest) lowest = l, best = i;
  }
  const auto choose = [&](auto&& goes) {
    chosen_.clear();
    for (std::size_t i = 0; i < list_.size(); ++i)
      if (goes(i)) chosen_.push_back(list_[i]);
    return std::span<const Window>(chosen_);
  };
  const auto keeps_both = [&](const Window& w) { return w.to(apex.x, apex.y) <= lowest * (1 + equal_share); };
  const auto left = choose([&](std::size_t i) {
    return has_left(apex, list_[i]) && (!both(list_[i]) || i <= best || keeps_both(list_[i]));
  });
  carry_left(apex, left, left.size());
  const auto right = choose([&](std::size_t i) {
    return has_right(apex, list_[i]) && (!both(list_[i]) || i >= best || keeps_both(list_[i]));
  });
  carry_right(apex, right, 0);
}

/// Lets a window have crossed one face more, which it entered so. What is too deep becomes empty: its lines went
/// straight over more faces than there are, so they met one twice, and no such line is a shortest path.
void Propagation::enter(Window& window, Entry entry) const {
  window.enter(entry, window.depth + 1);
  if (window.depth > 2 * deepest_merge_) window.high = window.low;
}

/// Makes `child` the lines of a window to the left of the apex; with `clipped` it also has lines to the apex, or beyond
/// it.
void Propagation::carry_left(const Apex& apex, const Window& window, bool clipped, Window& child) const {
  const Turn turn = turn_left(apex);
  const TurnedImage<double> image(turn, window.x, window.y);
  child = window;
  child.x = image.x(), child.y = image.y();
  child.low = image.low(window.low), child.high = clipped ? turn.limit : image.high(window.high);
  enter(child, Entry::left);
}

/// The same with the lines to the right of the apex.
void Propagation::carry_right(const Apex& apex, const Window& window, bool clipped, Window& child) const {
  const Turn turn = turn_right(apex);
  const TurnedImage<double> image(turn, window.x, window.y);
  child = window;
  child.x = image.x(), child.y = image.y();
  child.low = clipped ? 0 : image.low(window.low), child.high = image.high(window.high);
  enter(child, Entry::right);
}

/// Windows from `clipped` on also have lines to the apex, or beyond it.
void Propagation::carry_left(const Apex& apex, std::span<const Window> windows, std::size_t clipped) {
  if (windows.empty() || apex.left_is_boundary()) return;
  child_.clear();
  for (std::size_t i = 0; i < windows.size(); ++i) carry_left(apex, windows[i], i >= clipped, child_.emplace_back());
  send(apex.left());
}

/// Windows before `clipped` also have lines to the apex, or beyond it.
void Propagation::carry_right(const Apex& apex, std::span<const Window> windows, std::size_t clipped) {
  if (windows.empty() || apex.right_is_boundary()) return;
  child_.clear();
  for (std::size_t i = 0; i < windows.size(); ++i) carry_right(apex, windows[i], i < clipped, child_.emplace_back());
  send(apex.right());
}

/// Trims the windows that left a face through half-edge `edge`, in the frame of the other side, and hands on what is
/// left of them: what is behind a break waits as a run of its own.
void Propagation::send(Index edge) {
  if (surface_.is_fan(edge))  // windows of other faces come to the same half-edges
    for (Window& window : child_) window.set_entry(Entry::loose);
  trimming_.trim(child_);
  if (trimming_.breaks().empty()) return hand_on(child_, edge);
  WindowList all;  // handing on may trim
  std::swap(all, child_);
  const std::vector<std::uint32_t> breaks = trimming_.breaks();
  std::size_t end = all.size();
  for (auto first = breaks.rbegin(); first != breaks.rend(); end = *first++)
    hand_on(std::span(all).subspan(*first, end - *first), edge);
  hand_on(std::span(all).first(end), edge);
}

void Propagation::send_left(const Apex& apex, const Window& window, bool clipped) {
  const Index child = wavefront_.pool().add();
  carry_left(apex, window, clipped, wavefront_.pool()[child]);
  hand_on_alone(child, apex, apex.c);
}

void Propagation::send_right(const Apex& apex, const Window& window, bool clipped) {
  const Index child = wavefront_.pool().add();
  carry_right(apex, window, clipped, wavefront_.pool()[child]);
  hand_on_alone(child, apex, apex.b);
}

/// What `send` and `hand_on` do, for a single window, which stands in the pool, that left through edge i of the face.
void Propagation::hand_on_alone(Index child, const Apex& apex, int i) {
  const PackedMesh::Across across = PackedMesh::only_across(apex.face, i);
  const Window& window = wavefront_.pool()[child];
  if (across.half_edge != no_index && !window.empty() &&
      !is_close(window, {window.low, window.high}, apex.face.length[i])) {
    counts_.created += wavefront_.push_alone(child, across, apex.face.length[i], limit_);
    return;
  }
  child_.assign(1, window);
  wavefront_.pool().release(child);
  send(apex.half_edge / 3 * 3 + static_cast<Index>(i));
}

/// Lets a run wait at the other half-edges of an edge.
void Propagation::hand_on(std::span<const Window> run, Index edge) {
  if (surface_.branches(edge)) {
    list_pieces(run);
    fans_.claim(edge, pieces_);
    list_parts(run);
    run = parts_;
  }
  if (run.size() != 1 || !is_close(run[0], {run[0].low, run[0].high}, surface_.length(edge))) {
    counts_.created += wavefront_.push_run(run, edge, limit_);
    return;
  }
  const Window window = run[0];
  surface_.for_each_across(edge, [&](Index half_edge, bool is_mirrored) {
    WindowList present = std::exchange(list_, {window});
    if (is_mirrored) mirror(list_[0], surface_.length(edge));
    ++counts_.created;
    pass(half_edge);
    list_ = std::move(present);  // where it was in memory: a pass may be going on there
  });
}

}  // namespace geodrome::merged_windows
