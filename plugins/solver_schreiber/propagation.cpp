// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/propagation.hpp"

#include <algorithm>
#include <utility>

#include "plugins/common/exact/bisector.hpp"
#include "plugins/common/exact/close_image.hpp"
#include "plugins/common/exact/least_distance.hpp"
#include "plugins/solver_schreiber/claimant.hpp"
#include "plugins/solver_schreiber/claims.hpp"

namespace geodrome::schreiber {
namespace {

/// Returns the least distance of what the generators of a front claim of a half-edge. O(n).
double least_distance_of(const Front& front, double length) {
  double least = infinity;
  front.for_each([&](const Generator& g) {
    const Interval claim = claim_of(g, length);
    least = std::min(least, least_distance(g, std::min(claim.low, claim.high), std::max(claim.low, claim.high)));
  });
  return least;
}

/// The margin exceeds the rounding of the distance at which a generator dies.
constexpr double event_margin = 1e-9;

}  // namespace

Propagation::Propagation(const PackedMesh& surface, const Settings&)
    : VertexPropagation(surface),
      editor_(pool_),
      fans_(surface, editor_),
      waiting_(3 * surface.face_count(), surface.vertex_count()),
      times_passed_(3 * surface.face_count()) {}

void Propagation::begin(bool keep, double limit) {
  waiting_.clear();  // what a run that was stopped left behind
  VertexPropagation::begin(keep, limit);
  kept_.reset();
  if (keep) kept_.prepare(3 * surface_.face_count());
  fans_.reset();
  sources_.clear();
  for (const Index h : passed_) times_passed_[h] = 0;
  passed_.clear();
  editor_.counts() = {};
  counts_ = {};
  nodes_before_ = pool_.nodes_made();
}

void Propagation::next() {
  const WaitingFronts::Next next = waiting_.pop(arrivals_);
  if (next.vertex != no_index)
    emit(next.vertex);
  else
    process(next.half_edge);
}

void Propagation::send_wedge(const Apex& apex, const PseudoSource& from, double to_end, Entry entry) {
  const Angle to_low = angle_of(-to_end, from.y), to_high = angle_of(from.x, from.y);
  const Generator g{apex.length - from.x, -from.y,      from.sigma, to_low.cosine, to_low.sine,
                    to_high.cosine,       to_high.sine, infinity,   from.origin};
  if (g.is_sliver()) return;
  hand_on(Front(pool_, g), ends_of(g, g, surface_.length(apex.half_edge)), apex.half_edge, entry, Course{});
}

void Propagation::seed_face(const SurfacePoint& at, const Source& source, Index number) {
  sources_.push_back({at, source.start, number});
  VertexPropagation::seed_face(at, source, number);
}

/// Carries on everything that came to a half-edge as one front: fronts of one entry are united first, then the entries
/// are joined in their order.
void Propagation::process(Index half_edge) {
  if (arrivals_.size() == 1 && !surface_.branches(half_edge)) {
    Arrival arrival = std::move(arrivals_.front());
    arrivals_.clear();
    return pass(half_edge, std::move(arrival.front), arrival.ends, arrival.course);
  }
  const double length = surface_.length(half_edge);
  Front front(pool_);
  Course course{no_index};
  for (const Entry entry : {Entry::left, Entry::apex, Entry::right, Entry::loose}) {
    Arrival same{Front(pool_), {}, entry, {no_index, infinity, -infinity}};
    for (Arrival& arrival : arrivals_)
      if (arrival.entry == entry) unite(same, std::move(arrival), length);
    course.depth = std::min(course.depth, same.course.depth);
    if (entry == Entry::loose)
      editor_.merge(front, std::move(same.front), length);
    else
      editor_.join(front, std::move(same.front), length);
  }
  arrivals_.clear();
  if (surface_.branches(half_edge)) fans_.keep_nearest(front, half_edge);
  if (front.empty()) return;
  const Ends ends = ends_of(front, length);
  pass(half_edge, std::move(front), ends, course);
}

/// Unites fronts of one entry. The fronts came through the same half-edge unless they are loose.
void Propagation::unite(Arrival& all, Arrival arrival, double length) {
  const bool is_loose = all.entry == Entry::loose;
  if (!is_loose && arrival.course.is_left_of(all.course)) {
    editor_.join(arrival.front, std::move(all.front), length);
    all.front.swap(arrival.front);
  } else if (!is_loose && all.course.is_left_of(arrival.course)) {
    editor_.join(all.front, std::move(arrival.front), length);
  } else {
    editor_.merge(all.front, std::move(arrival.front), length);
  }
  all.course = all.course.with(arrival.course);
}

void Propagation::count_pass(Index half_edge, std::size_t generators) {
  std::uint8_t& times = times_passed_[half_edge];
  if (times == 0) passed_.push_back(half_edge);
  counts_.repeated += times > 0;
  if (times < 255) ++times;
  counts_.most = std::max<std::uint64_t>(counts_.most, times);
  ++counts_.passes;
  counts_.carried += generators;
  counts_.longest = std::max<std::uint64_t>(counts_.longest, generators);
}

/// Carries a front across the face of a half-edge.
void Propagation::pass(Index half_edge, Front front, Ends ends, Course course) {
  if (surface_.is_copy(half_edge / 3) && !keep_ && watched_.empty()) return;
  const Apex apex(surface_, half_edge);
  filter(front, ends, apex.length, labels_.distance(apex.start()), labels_.distance(apex.end()));
  if (front.empty()) return;
  count_pass(half_edge, front.size());
  const double widest = surface_.longest_side(half_edge / 3);
  // No point of the face to which the front is the shortest way is farther. What dies in the face beyond that distance
  // dies on rays that are no shortest ways, where whatever the front offers is in vain.
  const double until = (0.5 * (ends.at_low + ends.at_high + (ends.high - ends.low)) + widest) * (1 + event_margin);
  editor_.narrow(front, apex.length, until);
  if (keep_) kept_.keep(half_edge, front);
  if (!watched_.empty()) lower_watched(half_edge, front, until);
  if (surface_.is_copy(half_edge / 3)) return;
  if (course.depth >= surface_.face_count()) return;  // a shortest path crosses no face twice
  const Split split = split_at(apex, front, until);
  ++course.depth;
  if (!split.in_order) return carry_one_by_one(apex, front, course, until);
  lower_apex(apex, front, split);
  carry_on(apex, std::move(front), split, course, until);
}

/// Drops outer generators of a front as Xin and Wang do: |image x| - x falls along the half-edge, so a path over its
/// start that is shorter at x is shorter at every place before x too; likewise at the end.
void Propagation::filter(Front& front, Ends& ends, double length, double at_start, double at_end) {
  const auto longer = [](double way, double other) { return way > other + rounding_share * way; };
  const auto drop = [&](std::size_t i) {
    editor_.remove(front, i, {{}, length});
    if (!front.empty()) ends = ends_of(front, length);
  };
  Generator rooms[2];
  while (!front.empty() && longer(ends.at_low, at_start + ends.low)) {
    const Generator& g = front.look(0, rooms[0]);
    Interval claim = claim_of(g, length);
    if (front.size() > 1) {
      const Generator& next = front.look(1, rooms[1]);
      Interval other = claim_of(next, length);
      settle_pair(g, claim, next, other);
    }
    if (!longer(g.at(claim.high), at_start + claim.high)) break;
    drop(0);
  }
  while (!front.empty() && longer(ends.at_high, at_end + (length - ends.high))) {
    const Generator& g = front.look(front.size() - 1, rooms[0]);
    Interval claim = claim_of(g, length);
    if (front.size() > 1) {
      const Generator& next = front.look(front.size() - 2, rooms[1]);
      Interval other = claim_of(next, length);
      settle_pair(next, other, g, claim);
    }
    if (!longer(g.at(claim.low), at_end + (length - claim.low))) break;
    drop(front.size() - 1);
  }
}

void Propagation::lower_watched(Index half_edge, const Front& front, double until) {
  for_each_watched(half_edge, [&](Watched& watched, double x, double y) {
    const Generator g = owner_at(front, x, y, until);
    const double way = way_through(g, surface_.length(half_edge), x, y, watched.distance).distance;
    if (way < watched.distance) watched.distance = way, watched.source = source_of(g.origin);
  });
}

// ---------------------------------------------------------------------------------------------------------------------
// Across a face

void Propagation::carry_on(const Apex& apex, Front front, const Split& split, const Course& course, double until) {
  Front right = front.split(split.right_begin);
  Front left = std::move(front);
  editor_.counts().splits += split.covered;
  const std::size_t ties = split.covered ? split.left_end - split.right_begin : 0;
  for (std::size_t i = 0; i < ties; ++i) left.append(Front(pool_, right[i]));
  // Rays on the wrong side of the apex are not needed, and would pass it there.
  editor_.end_at(left, apex.x, apex.y);
  editor_.begin_at(right, apex.x, apex.y);
  carry(apex, std::move(left), true, course, until);
  carry(apex, std::move(right), false, course, until);
}

/// Carries on a front that is out of order at the apex: each generator on its own, with what it owns of the half-edge,
/// to the sides to which it has rays.
void Propagation::carry_one_by_one(const Apex& apex, const Front& front, const Course& course, double until) {
  ++counts_.tangled;
  const double x = apex.x, y = apex.y;
  std::vector<Generator> all;
  editor_.trimmed(front, apex.length).for_each([&](const Generator& g) { all.push_back(g); });
  std::size_t best = all.size();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].covers(x, y)) {
      lower_apex_bent(apex, all[i]);
      continue;
    }
    lower_apex_by(apex, all[i], all[i].x, all[i].to(x, y));
    if (best == all.size() || all[i].to(x, y) < all[best].to(x, y)) best = i;
  }
  std::vector<Generator> left, right;
  for (std::size_t i = 0; i < all.size(); ++i) {
    Generator g = all[i];
    const bool covers = g.covers(x, y), as_near = covers && g.to(x, y) <= all[best].to(x, y) * (1 + equal_share);
    if (g.has_left(x, y) && (!covers || i <= best || as_near)) {
      if (covers) g.set_high(x, y);
      left.push_back(g);
    }
    g = all[i];
    if (g.has_right(x, y) && (!covers || i >= best || as_near)) {
      if (covers) g.set_low(x, y);
      right.push_back(g);
    }
  }
  carry(apex, editor_.front_of(std::move(left)), true, course, until);
  carry(apex, editor_.front_of(std::move(right)), false, course, until);
  lower_along_edges(apex);
}

/// Carries a front through the left or right edge of a face.
void Propagation::carry(const Apex& apex, Front front, bool to_left, Course course, double until) {
  if (front.empty() || (to_left ? apex.left_is_boundary() : apex.right_is_boundary())) return;
  const double cosine = apex.face.cosine[to_left ? apex.a : apex.b], sine = apex.face.sine[to_left ? apex.a : apex.b];
  const Motion turn = to_left ? Motion{cosine, -sine, 0, 0}
                              : Motion{cosine, sine, apex.right_length() - cosine * apex.length, -sine * apex.length};
  course.low = front.front().low(apex.length), course.high = front.back().high(apex.length);
  front.move(turn);
  const double length = to_left ? apex.left_length() : apex.right_length();
  const FrontEditor::Before before{turn.inverse(), apex.length};
  Ends ends = editor_.fit(front, length, before);
  if (editor_.bury(front, length, until, before)) ends = editor_.fit(front, length, before);
  if (front.empty()) return;
  hand_on(std::move(front), ends, to_left ? apex.left() : apex.right(), to_left ? Entry::left : Entry::right, course);
}

/// Lets a front wait at every other half-edge on an edge. The front is in the frame of a half-edge that runs against
/// `edge`.
void Propagation::hand_on(Front front, Ends ends, Index edge, Entry entry, const Course& course) {
  const double length = surface_.length(edge);
  if (surface_.is_fan(edge)) entry = Entry::loose;
  if (surface_.branches(edge)) {
    fans_.claim(front, edge);
    if (front.empty()) return;
    ends = ends_of(front, length);
  }
  const double near = std::max(0.0, 0.5 * (ends.at_low + ends.at_high - std::max(0.0, ends.high - ends.low)));
  if (near * (1 - rounding_share) > limit_ && least_distance_of(front, length) * (1 - rounding_share) > limit_) return;
  const bool at_once = front.size() == 1 && is_close(front[0], {0, length}, length);
  if (at_once) {
    const Generator g = front[0];
    if (left_to_end({g.x, g.y, g.sigma, g.origin}, edge)) return;
  }
  surface_.for_each_across(edge, [&](Index half_edge, bool same_way) {
    Front own = same_way ? editor_.mirrored(front, length) : front;
    const Ends own_ends = same_way ? ends.mirrored(length) : ends;
    if (at_once) return pass(half_edge, std::move(own), own_ends, course);
    waiting_.push(
        half_edge, near + patience * length,
        {std::move(own), own_ends, same_way ? mirrored(entry) : entry, same_way ? course.mirrored() : course});
  });
}

}  // namespace geodrome::schreiber
