// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "plugins/solver_schreiber/envelope.hpp"
#include "plugins/solver_schreiber/generator.hpp"
#include "plugins/solver_schreiber/sequence.hpp"

namespace geodrome::schreiber {

/// A wavefront that enters a face through a half-edge: generators in the order of their rays, which cross neither in
/// the face below nor on the half-edge. Boundaries between neighbours are not stored: they are where the nearer one
/// changes.
using Front = Sequence<Generator>;
using FrontPool = Front::Pool;

/// Fronts of so many generators at most are looked at whole where longer ones are searched: it costs little, and finds
/// what is in no order by rounding.
inline constexpr std::size_t short_front = 32;

/// Where a front begins and ends on a half-edge, and how far it has come there.
struct Ends {
  double low, high, at_low, at_high;

  /// Seen from a half-edge of `length` that runs the other way.
  Ends mirrored(double length) const { return {length - high, length - low, at_high, at_low}; }
};
inline Ends ends_of(const Generator& first, const Generator& last, double length) {
  const double low = first.low(length), high = last.high(length);
  return {low, high, first.at(low), last.at(high)};
}
/// Precondition: not empty.
inline Ends ends_of(const Front& front, double length) {
  Generator rooms[2];
  return ends_of(front.look(0, rooms[0]), front.look(front.size() - 1, rooms[1]), length);
}

/// What happened to fronts.
struct FrontCounts {
  std::uint64_t events = 0;     ///< generators that died between their neighbours or at a seam
  std::uint64_t joins = 0;      ///< fronts joined
  std::uint64_t splits = 0;     ///< fronts split at a vertex
  std::uint64_t envelopes = 0;  ///< fronts of no common order, cut against each other point by point
};

/// The operations on fronts where they cross a half-edge of a given length, in its frame. All of them drop generators,
/// or leave it to a neighbour to have a place, by one lemma only:
///
///   Let the rays of generators L and R enter the face below the half-edge so that those of L enter to the left of
///   those of R. If at a point x that a ray of L reaches L is not farther than R (seen from x or not), then no ray of R
///   to the left of x is needed. Likewise with left and right exchanged.
///
/// For the ray of R to y < x and that of L to x cross, at q: |R q| + |q x| >= |R x| >= |L x| = |L q| + |q x|.
class FrontEditor {
 public:
  explicit FrontEditor(FrontPool& pool) : pool_(pool) {}

  /// Computes the key of generator i, if there is one, after a neighbour of it changed.
  void renew_key(Front& front, std::size_t i);

  /// Those of the generators before and behind place i, where they became neighbours or one became the outermost.
  void renew_seam(Front& front, std::size_t i);

  /// A half-edge that a front comes from.
  struct Before {
    Motion back;  ///< to its frame
    double length;
  };
  /// Removes generator i, which still had something of the half-edge `before`. What its neighbours had of that stays
  /// all that they have: beyond their boundaries with the one removed that was as near, and only its own rays are known
  /// to pass the vertices on their side.
  void remove(Front& front, std::size_t i, const Before& before);

  /// Bounds the first and last ray by the ends of the half-edge: beyond them they pass its vertices on the wrong side.
  /// What has nothing of the half-edge at an end goes. The ends of what is left, if anything. Precondition, also of
  /// `bury`: no ray passes the apex of the face on the other side of it (`end_at`, `begin_at`).
  Ends fit(Front& front, double length, const Before& before);

  /// Bounds the rays of generators that can die up to `until`, and of those beside them, by the ends of the half-edge:
  /// a neighbour that dies keeps rays beyond a vertex in check no longer.
  void narrow(Front& front, double length, double until);

  /// Removes the generators that have died between the half-edge before and this one, `length` long. Only those with
  /// keys up to `until` can have. True if there were some.
  bool bury(Front& front, double length, double until, const Before& before);

  /// Leaves no rays to the right (left) of a point, at which the front ends (begins) from now on. In a short
  /// front all are looked at; else those in a row at that end, behind which none has any but the dead.
  void end_at(Front& front, double px, double py);
  void begin_at(Front& front, double px, double py);

  /// A front whose rays are bounded by what its generators have of a half-edge. O(n).
  Front trimmed(const Front& front, double length);

  /// Joins `right`, all rays of which enter to the right of those of `left`.
  void join(Front& left, Front right, double length);

  /// Two fronts of which no order is known: each has what is its own of the half-edge, which may come in pieces. O(n +
  /// m).
  void merge(Front& front, Front other, double length);

  /// A front of generators in order, whose keys are computed. O(n).
  Front front_of(std::vector<Generator> generators);

  /// The generators in reversed order, seen from a half-edge that runs the other way.
  Front mirrored(const Front& front, double length);

  const FrontCounts& counts() const { return counts_; }
  FrontCounts& counts() { return counts_; }

 private:
  Front front_of(const Pieces& pieces);

  void narrow_one(Front& front, std::size_t i, double length);

  static void aim_low(Front& front, std::size_t i, Generator g, double px, double py);
  static void aim_high(Front& front, std::size_t i, Generator g, double px, double py);
  static void set_low(Front& front, std::size_t i, const Generator& g);
  static void set_high(Front& front, std::size_t i, const Generator& g);

  FrontPool& pool_;
  FrontCounts counts_;
  std::vector<std::pair<double, std::size_t>> suspects_;  ///< key and place of generators that can have died
};

}  // namespace geodrome::schreiber
