// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "plugins/solver_schreiber/envelope.hpp"
#include "plugins/solver_schreiber/generator.hpp"
#include "plugins/solver_schreiber/sequence.hpp"

namespace geodrome::schreiber {

/// A front: a wavefront that enters a face through a half-edge, as its generators in the order of their rays, which
/// cross neither in the face below nor on the half-edge. Boundaries between neighbours are not stored: they are where
/// the nearer generator changes.
using Front = Sequence<Generator>;
using FrontPool = Front::Pool;

/// Fronts of at most so many generators are looked at whole, where longer ones are searched: that costs little, and
/// finds generators that rounding has put out of order.
inline constexpr std::size_t short_front = 32;

/// The ends of a front on a half-edge, and the distances of the front there.
struct Ends {
  double low, high, at_low, at_high;

  /// Returns the ends as seen from a half-edge of `length` that runs the other way.
  Ends mirrored(double length) const { return {length - high, length - low, at_high, at_low}; }
};
inline Ends ends_of(const Generator& first, const Generator& last, double length) {
  const double low = first.low(length), high = last.high(length);
  return {low, high, first.at(low), last.at(high)};
}
/// Returns the ends of a front. Precondition: the front is not empty.
inline Ends ends_of(const Front& front, double length) {
  Generator rooms[2];
  return ends_of(front.look(0, rooms[0]), front.look(front.size() - 1, rooms[1]), length);
}

/// Counts of what happened to fronts.
struct FrontCounts {
  std::uint64_t events = 0;     ///< generators that died between their neighbours or at a seam
  std::uint64_t joins = 0;      ///< fronts joined
  std::uint64_t splits = 0;     ///< fronts split at a vertex
  std::uint64_t envelopes = 0;  ///< fronts of no common order, cut against each other point by point
};

/// The operations on fronts where they cross a half-edge of a given length, in its frame. All of them drop generators,
/// or leave a place to a neighbour, by the lemma of ordered neighbours alone (ordered_pair.hpp).
class FrontEditor {
 public:
  explicit FrontEditor(FrontPool& pool) : pool_(pool) {}

  /// Recomputes the key of generator i after a neighbour of it changed; does nothing if there is no generator i.
  void renew_key(Front& front, std::size_t i);

  /// Recomputes the keys of generators i - 1 and i after they became neighbours, or of the one that became outermost.
  void renew_seam(Front& front, std::size_t i);

  /// A half-edge that a front comes from.
  struct Before {
    Motion back;  ///< to its frame
    double length;
  };
  /// Removes generator i, which still claimed a part of the half-edge `before`. Its neighbours keep the parts of their
  /// claims there that were no farther than the removed generator, and get rays that end there: only the rays of the
  /// removed generator are known to pass the vertices beyond.
  void remove(Front& front, std::size_t i, const Before& before);

  /// Removes generators at both ends that cross no part of the half-edge, and bounds the first and the last ray by the
  /// ends of the half-edge: beyond them a ray passes a vertex on the wrong side. Returns the ends of what is left, if
  /// anything. Precondition, also of `bury`: no ray passes the apex of the face on the other side of it (`end_at`,
  /// `begin_at`).
  Ends fit(Front& front, double length, const Before& before);

  /// Bounds the rays of generators that can die up to the distance `until`, and of those beside them, by the ends of
  /// the half-edge: a neighbour that dies no longer keeps rays beyond a vertex in check.
  void narrow(Front& front, double length, double until);

  /// Removes the generators that have died between the half-edge before and this one, `length` long, and tells whether
  /// there were some. Only generators with keys up to `until` can have died.
  bool bury(Front& front, double length, double until, const Before& before);

  /// Remove all rays to the right (left) of a point, at which the front ends (begins) from now on. All generators of a
  /// short front are looked at; of a longer one only those in a row at that end, since only dead generators have such
  /// rays behind the row.
  void end_at(Front& front, double px, double py);
  void begin_at(Front& front, double px, double py);

  /// Returns a front with rays bounded by what each generator owns of the half-edge. O(n).
  Front trimmed(const Front& front, double length);

  /// Appends `right`, all rays of which enter to the right of those of `left`.
  void join(Front& left, Front right, double length);

  /// Merges two fronts of which no order is known: the nearest generator stays at each place of the half-edge. A
  /// generator may come out in pieces. O(n + m).
  void merge(Front& front, Front other, double length);

  /// Returns a front of generators in order, with keys computed. O(n).
  Front front_of(std::vector<Generator> generators);

  /// Returns a front of ascending pieces, with rays bounded by them and keys computed. O(n).
  Front front_of(const Pieces& pieces);

  /// Returns the generators in reversed order, as seen from a half-edge that runs the other way.
  Front mirrored(const Front& front, double length);

  const FrontCounts& counts() const { return counts_; }
  FrontCounts& counts() { return counts_; }

 private:
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
