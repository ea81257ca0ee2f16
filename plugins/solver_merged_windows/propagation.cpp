// SPDX-License-Identifier: MIT
#include "plugins/solver_merged_windows/propagation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "plugins/common/mesh/prefetch.hpp"

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

}  // namespace

Propagation::Propagation(const PackedMesh& surface, const Settings& settings)
    : VertexPropagation(surface),
      settings_(settings),
      wavefront_(surface),
      merging_(settings.delta),
      upper_(surface.vertex_count()),
      fans_(surface),
      deepest_merge_(static_cast<std::uint32_t>(std::min<std::size_t>(surface.face_count(), Window::deepest / 2))) {}

void Propagation::begin(bool keep, double limit) {
  wavefront_.clear();  // what a run that was stopped left behind
  upper_.reset(labels_.touched(), keep);
  VertexPropagation::begin(false, limit);
  keep_ = keep;
  kept_.reset();
  if (keep) kept_.prepare(3 * surface_.face_count());
  trimming_.reset(), merging_.reset(), fans_.reset();
  counts_ = {};
}

void Propagation::next() {
  const SurfaceQueue::Next next = wavefront_.pop([this](Index vertex) {
    prefetch(&labels_[vertex]);
    prefetch(&upper_[vertex]);
  });
  if (next.is_vertex())
    emit(next.element);
  else
    process(next.element, next.first);
}

/// Throws MergingFails; not when much of the work is done, which would be lost.
void Propagation::polled() const {
  constexpr std::uint64_t enough_passes = 768;
  const std::uint64_t late = enough_passes + surface_.face_count() / 6;
  if (counts_.passes < enough_passes || counts_.passes > late) return;
  const auto& [tried, done] = merging_.counts();
  const auto times = [](double most, std::uint64_t count) { return most * static_cast<double>(count); };
  if (static_cast<double>(counts_.propagated) > times(settings_.long_list, counts_.passes) ||
      static_cast<double>(tried) > times(settings_.many_tries, done))
    throw MergingFails{};
}

void Propagation::lowered_along_edge(Index vertex, Index from, double length) {
  const FoundDistance& found = upper_[from];
  upper_.offer(vertex, {found.distance + length, found.source}, {.before = upper_.way_to(from)});
}

void Propagation::lowered_straight(Index vertex, double distance, Index source) {
  upper_.offer(vertex, {distance, source}, {});
}

void Propagation::lowered_at_source(Index vertex, double distance, Index source) {
  upper_.offer(vertex, {distance, source}, {.at_source = true});
}

void Propagation::send_wedge(const Apex& apex, const PseudoSource& from, double, Entry entry) {
  Window window{apex.length - from.x, -from.y, from.sigma, 0, apex.length};
  const auto vertices = static_cast<Index>(surface_.vertex_count());
  const bool from_vertex = from.origin < vertices;
  window.slack = from_vertex ? upper_[from.origin].distance - from.sigma : 0;
  window.origin = from_vertex ? vertices + upper_[from.origin].source : from.origin;
  window.parent = from_vertex ? way_bit | upper_.way_to(from.origin) : no_index;
  window.depth = 1, window.from_face_below = entry == Entry::loose;
  window.set_entry(entry);
  hand_on({&window, 1}, apex.half_edge);
}

/// Carries on what waits at a half-edge, as one list.
void Propagation::process(Index half_edge, Index window) {
  WindowPool& pool = wavefront_.pool();
  const Index second = pool[window].next;
  if (!keep_ && watched_.empty() && !surface_.is_fan(half_edge)) {
    if (second == no_index) {
      const Window present = pool[window];
      pool.release(window);
      return pass_alone(half_edge, present);
    }
    if (pool[second].next == no_index && process_two(half_edge, window, second)) return;
  }
  list_.clear();
  gather(window);
  if (surface_.branches(half_edge)) keep_nearest(half_edge);
  if (!list_.empty()) pass(half_edge);
}

/// Several windows: one run of each entry in their order, the others merged into them.
void Propagation::gather(Index window) {
  WindowPool& pool = wavefront_.pool();
  gathered_.clear(), ends_.clear();
  std::size_t middle = 0;
  while (window != no_index) {
    const Window& next = list_.emplace_back(pool[window]);
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

/// Carries the list across the face of a half-edge.
void Propagation::pass(Index half_edge) {
  const bool is_copy = surface_.is_copy(half_edge / 3);
  if (is_copy && !keep_ && watched_.empty()) return;
  const Apex apex(surface_, half_edge);
  filter(apex);
  if (list_.empty()) return;
  if (list_.size() > 1 && !surface_.is_fan(half_edge))
    merge(apex);
  else if (keep_)
    kept_.begin_pass(half_edge), keep_carried();
  ++counts_.passes;
  counts_.propagated += list_.size();
  counts_.longest = std::max<std::uint64_t>(counts_.longest, list_.size());
  if (!watched_.empty()) lower_watched(half_edge);

  if (is_copy) return;
  if (list_.size() == 1)
    cross_alone(apex, Window(list_[0]));  // what goes on at once may take its place
  else
    cross(apex);
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

/// Whether windows may become one as far as it is not for Merging to say: they have one source and are not too deep.
bool Propagation::may_join(const Window& a, const Window& b) const {
  return a.origin == b.origin && std::max<std::uint32_t>(a.depth, b.depth) <= deepest_merge_;
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
      [this](const Window& a, const Window& b) { return may_join(a, b); },
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

}  // namespace geodrome::merged_windows
