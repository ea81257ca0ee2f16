// SPDX-License-Identifier: MIT
#include "plugins/solver_merged_windows/propagation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "plugins/common/exact/bisector.hpp"
#include "plugins/common/exact/turn.hpp"

namespace geodrome::merged_windows {
namespace {

/// How near a line through a point of a half-edge, inside the face below, lets the corner at that point be cut, as a
/// share of the point's distance from the nearer end: the sine of the smaller angle of that face at the ends of the
/// half-edge, with 1 for an obtuse one. 0 for a face without area. The half-edge is on edge i of the face.
double mirror_sine(const PackedMesh::Face& face, int i) {
  const int j = (i + 1) % 3;
  const double of_i = face.cosine[i] <= 0 ? 1 : face.sine[i], of_j = face.cosine[j] <= 0 ? 1 : face.sine[j];
  const bool flat = !(face.sine[i] > 0 && face.sine[j] > 0);
  return flat ? 0 : std::min(of_i, of_j);
}

bool has_left(const Apex& apex, const Window& w) { return side_of_line(w.x, w.y, w.low, apex.x, apex.y) < 0; }
bool has_right(const Apex& apex, const Window& w) { return side_of_line(w.x, w.y, w.high, apex.x, apex.y) > 0; }

/// Whether the image is close to the half-edge, between the ends of its window: all its lines cross at nearly one
/// place, which rounding does not tell apart any more. Such a window goes on at once and alone, so that its lines are
/// not cut by places on that half-edge. (On faces without area the image lies on the half-edge.)
bool is_close(const Window& w, double length) {
  return -w.y <= close_share * length && w.low < w.x && w.x < w.high;
}

}  // namespace

Propagation::Propagation(const PackedMesh& surface, const Settings& settings)
    : VertexPropagation(surface),
      long_list_(settings.long_list),
      wavefront_(surface),
      merging_(settings.delta),
      upper_(surface.vertex_count()),
      fans_(surface),
      deepest_merge_(std::min<std::size_t>(surface.face_count(), Window::deepest / 2)) {}

void Propagation::begin(bool keep, double limit) {
  wavefront_.clear();  // what a run that was stopped left behind
  upper_.reset(labels_.touched(), keep);
  VertexPropagation::begin(false, limit);
  keep_ = keep;
  kept_.reset();
  if (keep) kept_.prepare(3 * surface_.face_count());
  trimming_.reset(), merging_.reset(), fans_.reset();
  one_source_ = true;
  counts_ = {};
}

void Propagation::next() {
  const Wavefront::Next next = wavefront_.pop([this](Index vertex) {
    __builtin_prefetch(&labels_[vertex]);
    __builtin_prefetch(&upper_[vertex]);
  });
  if (next.vertex != no_index)
    emit(next.vertex);
  else
    process(next.half_edge, next.window);
}

/// Throws LongLists.
void Propagation::polled() const {
  constexpr std::uint64_t enough_passes = 512;
  const auto passes = static_cast<double>(std::max(counts_.passes, enough_passes));
  if (static_cast<double>(counts_.propagated) > long_list_ * passes) throw LongLists{};
}

void Propagation::seed(const Source& source, Index number) {
  one_source_ = number == 0;
  VertexPropagation::seed(source, number);
}

void Propagation::lowered_along_edge(Index vertex, Index from, double length) {
  const FoundDistance& found = upper_[from];
  upper_.offer(vertex, {found.distance + length, found.source}, {.vertex = from});
}

void Propagation::lowered_straight(Index vertex, double distance, Index source) {
  upper_.offer(vertex, {distance, source}, {});
}

void Propagation::lowered_at_source(Index vertex, double distance, Index source) {
  upper_.offer(vertex, {distance, source}, {.vertex = vertex});
}

void Propagation::send_wedge(const Apex& apex, const PseudoSource& from, double, Entry entry) {
  Window window{apex.length - from.x, -from.y, from.sigma, 0, apex.length};
  const bool from_vertex = from.origin < surface_.vertex_count();
  window.slack = from_vertex ? upper_[from.origin].distance - from.sigma : 0;
  window.origin = from.origin, window.parent = no_index;
  window.depth = 1, window.from_face_below = entry == Entry::loose;
  window.set_entry(entry);
  hand_on({&window, 1}, apex.half_edge);
}

/// Carries on what waits at a half-edge, as one list.
void Propagation::process(Index half_edge, Index window) {
  WindowPool& pool = wavefront_.pool();
  const bool alone = pool[window].next == no_index;
  if (alone && !keep_ && watched_.empty() && !surface_.is_fan(half_edge)) {
    const Window present = pool[window];
    pool.release(window);
    return pass_alone(half_edge, present);
  }
  list_.clear();
  const std::uint32_t depth = gather(window);
  if (surface_.branches(half_edge)) keep_nearest(half_edge);
  if (!list_.empty()) pass(half_edge, depth);
}

/// Several windows: one run of each entry in their order, the others merged into them. Returns the least depth.
std::uint32_t Propagation::gather(Index window) {
  WindowPool& pool = wavefront_.pool();
  gathered_.clear(), ends_.clear();
  std::uint32_t depth = Window::deepest;
  std::size_t middle = 0;
  while (window != no_index) {
    const Window& next = list_.emplace_back(pool[window]);
    depth = std::min<std::uint32_t>(depth, next.depth);
    pool.release(std::exchange(window, next.next));
    if (!next.ends_run) continue;
    if (next.entry() == Entry::loose || (middle > 0 && !trimming_.join(list_, middle))) {
      // In no order with what is in the list: it comes after all that is.
      gathered_.insert(gathered_.end(), list_.begin() + static_cast<std::ptrdiff_t>(middle), list_.end());
      ends_.push_back(gathered_.size());
      list_.resize(middle);
    }
    middle = list_.size();
  }
  for (std::size_t i = 0, first = 0; i < ends_.size(); first = ends_[i++])
    trimming_.merge(list_, std::span(gathered_).subspan(first, ends_[i] - first));
  return depth;
}

/// Drops the parts of the list that something lower has come to since, at an edge of more than two faces.
void Propagation::keep_nearest(Index half_edge) {
  list_pieces(list_);
  fans_.keep_nearest(half_edge, pieces_);
  list_parts(list_);
  std::swap(list_, parts_);
}

void Propagation::list_pieces(std::span<const Window> windows) {
  pieces_.clear();
  for (const Window& w : windows)
    pieces_.push_back({w.x, w.y, w.sigma, w.low, w.high, static_cast<std::uint32_t>(pieces_.size())});
}

void Propagation::list_parts(std::span<const Window> windows) {
  parts_.clear();
  for (const EdgePiece& piece : pieces_) {
    parts_.push_back(windows[piece.number]);
    parts_.back().low = piece.low, parts_.back().high = piece.high;
  }
}

/// Carries the list, which has crossed `depth` faces at least, across the face of a half-edge.
void Propagation::pass(Index half_edge, std::uint32_t depth) {
  const bool is_copy = surface_.is_copy(half_edge / 3);
  if (is_copy && !keep_ && watched_.empty()) return;
  const Apex apex(surface_, half_edge);
  filter(apex);
  if (list_.empty()) return;
  if (list_.size() > 1 && depth <= deepest_merge_ && !surface_.is_fan(half_edge))
    merge(apex);
  else if (keep_)
    kept_.begin_pass(half_edge), keep_carried();
  ++counts_.passes;
  counts_.propagated += list_.size();
  counts_.longest = std::max<std::uint64_t>(counts_.longest, list_.size());
  if (!watched_.empty()) lower_watched(half_edge);

  if (is_copy) return;
  if (depth >= 2 * deepest_merge_) return;  // a line that goes straight over as many faces as there are meets one twice
  if (list_.size() == 1)
    cross_alone(apex, Window(list_[0]), depth);  // what goes on at once may take its place
  else
    cross(apex, depth);
}

/// Xin and Wang's filter, and the trimming that follows from it: |image x| - x falls along the half-edge, so where the
/// way over its start is shorter at x it is shorter at everything before x too; likewise at the end.
void Propagation::filter(const Apex& apex) {
  const double at_start = labels_.distance(apex.start()), at_end = labels_.distance(apex.end());
  const auto longer = [](double way, double other) { return way > other + rounding_share * way; };
  std::size_t first = 0, last = list_.size();
  while (first < last && longer(list_[first].at(list_[first].high), at_start + list_[first].high)) ++first;
  while (first < last && longer(list_[last - 1].at(list_[last - 1].low), at_end + (apex.length - list_[last - 1].low)))
    --last;
  if (last - first == list_.size()) return;
  counts_.filtered += list_.size() - (last - first);
  list_.erase(list_.begin() + static_cast<std::ptrdiff_t>(last), list_.end());
  list_.erase(list_.begin(), list_.begin() + static_cast<std::ptrdiff_t>(first));
}

bool Propagation::same_source(const Window& a, const Window& b) const {
  return one_source_ || a.origin == b.origin || source_of(a.origin) == source_of(b.origin);
}

/// mirror_sine of a half-edge, seen from the face below it.
double Propagation::sine_below(Index half_edge) const {
  double sine = 1;
  surface_.for_each_across(half_edge, [&](Index other, bool) {
    sine = std::min(sine, mirror_sine(surface_.face_of(other), static_cast<int>(other % 3)));
  });
  return sine;
}

/// Puts merged windows in the place of those of the list, and keeps both if anything is to be kept.
void Propagation::merge(const Apex& apex) {
  if (keep_) kept_.begin_pass(apex.half_edge);
  merging_.merge(
      list_, {apex.length, sine_below(apex.half_edge)},
      [this](const Window& a, const Window& b) { return same_source(a, b); },
      [this](std::size_t first, std::size_t last) {
        if (!keep_) return no_index;
        const Index number = kept_.add(list_[first]);
        for (std::size_t i = first + 1; i < last; ++i) kept_.add(list_[i]);
        return number;
      });
  if (keep_) keep_carried();
}

void Propagation::keep_carried() {
  kept_.carried_from_here();
  for (Window& window : list_) window.parent = kept_.add(window);
}

void Propagation::lower_watched(Index half_edge) {
  for_each_watched(half_edge, [&](Watched& watched, double x, double y) {
    for (const Window& window : list_) {
      const double way = way_through(window, x, y);
      if (way < watched.distance) watched.distance = way, watched.source = source_of(window.origin);
    }
  });
}

// ---------------------------------------------------------------------------------------------------------------------
// Across a face

/// What `pass` does, for a single window of which nothing is to be kept: most windows are alone.
void Propagation::pass_alone(Index half_edge, const Window& window) {
  const Apex apex(surface_, half_edge);
  if (is_needless(window, apex)) {
    ++counts_.filtered;
    return;
  }
  ++counts_.passes, ++counts_.propagated;
  if (window.depth < 2 * deepest_merge_) cross_alone(apex, window, window.depth);
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

void Propagation::cross_alone(const Apex& apex, const Window& window, std::uint32_t depth) {
  const bool left = has_left(apex, window), right = has_right(apex, window);
  if (left && right)
    lower_apex_straight(apex, window);
  else
    lower_apex_bent(apex, window, left ? window.high : window.low);
  lower_along_edges(apex);
  if (left && !apex.left_is_boundary()) hand_on_alone(carried_left(apex, window, right, depth), apex, apex.c);
  if (right && !apex.right_is_boundary()) hand_on_alone(carried_right(apex, window, left, depth), apex, apex.b);
}

void Propagation::cross(const Apex& apex, std::uint32_t depth) {
  const Split split = split_at(apex);
  if (!split.in_order) return carry_one_by_one(apex, depth);
  lower_apex(apex, split);
  const std::span<const Window> list(list_);
  carry_left(apex, list.first(split.covered() ? split.last_best : split.left_end), split.right_begin, depth);
  const std::size_t first_right = split.covered() ? split.first_best : split.right_begin;
  carry_right(apex, list.subspan(first_right), split.left_end - std::min(split.left_end, first_right), depth);
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
  lower_apex_from(apex, image, x, value, [] { return Step{}; });
}

void Propagation::carry_one_by_one(const Apex& apex, std::uint32_t depth) {
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
  carry_left(apex, left, left.size(), depth);
  const auto right = choose([&](std::size_t i) {
    return has_right(apex, list_[i]) && (!both(list_[i]) || i >= best || keeps_both(list_[i]));
  });
  carry_right(apex, right, 0, depth);
}

/// The lines of a window to the left of the apex; with `clipped` it also has lines to the apex, or beyond it.
Window Propagation::carried_left(const Apex& apex, const Window& window, bool clipped,
                                   std::uint32_t depth) const {
  const Turn turn = turn_left(apex);
  const TurnedImage<double> image(turn, window.x, window.y);
  Window child = window;
  child.x = image.x(), child.y = image.y();
  child.low = image.low(window.low), child.high = clipped ? turn.limit : image.high(window.high);
  child.enter(Entry::left, depth + 1);
  return child;
}

/// The lines to the right of the apex.
Window Propagation::carried_right(const Apex& apex, const Window& window, bool clipped,
                                   std::uint32_t depth) const {
  const Turn turn = turn_right(apex);
  const TurnedImage<double> image(turn, window.x, window.y);
  Window child = window;
  child.x = image.x(), child.y = image.y();
  child.low = clipped ? 0 : image.low(window.low), child.high = image.high(window.high);
  child.enter(Entry::right, depth + 1);
  return child;
}

/// Windows from `clipped` on also have lines to the apex, or beyond it.
void Propagation::carry_left(const Apex& apex, std::span<const Window> windows, std::size_t clipped,
                             std::uint32_t depth) {
  if (windows.empty() || apex.left_is_boundary()) return;
  child_.clear();
  for (std::size_t i = 0; i < windows.size(); ++i) child_.push_back(carried_left(apex, windows[i], i >= clipped, depth));
  send(apex.left());
}

/// Windows before `clipped` also have lines to the apex, or beyond it.
void Propagation::carry_right(const Apex& apex, std::span<const Window> windows, std::size_t clipped,
                             std::uint32_t depth) {
  if (windows.empty() || apex.right_is_boundary()) return;
  child_.clear();
  for (std::size_t i = 0; i < windows.size(); ++i) child_.push_back(carried_right(apex, windows[i], i < clipped, depth));
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

/// What `send` and `hand_on` do, for a single window that left through edge i of the face.
void Propagation::hand_on_alone(const Window& window, const Apex& apex, int i) {
  const PackedMesh::Across across = PackedMesh::only_across(apex.face, i);
  if (across.half_edge != no_index && !window.empty() && !is_close(window, apex.face.length[i])) {
    counts_.created += wavefront_.push_alone(window, across, apex.face.length[i], limit_);
    return;
  }
  child_.assign(1, window);
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
  if (run.size() != 1 || !is_close(run[0], surface_.length(edge))) {
    counts_.created += wavefront_.push_run(run, edge, limit_);
    return;
  }
  const Window window = run[0];
  surface_.for_each_across(edge, [&](Index half_edge, bool is_mirrored) {
    WindowList present = std::exchange(list_, {is_mirrored ? mirrored(window, surface_.length(edge)) : window});
    ++counts_.created;
    pass(half_edge, window.depth);
    list_ = std::move(present);  // where it was in memory: a pass may be going on there
  });
}

}  // namespace geodrome::merged_windows
