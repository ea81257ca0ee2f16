// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geodrome/geometry.hpp"
#include "plugins/solver_aleksandrov/intrinsic/plane.hpp"

namespace geodrome::aleksandrov {

/// One change of a triangulation: some triangles were replaced by others that cover the same part of the surface, all
/// of them with corners among four points of a plane. A flip replaces two by two, the split of a face one by three, the
/// split of an edge one by two in each of its faces. In a flip points 0 and 1 are the ends of the edge that goes, and
/// `before[0]` lies on its left.
struct Rearrangement {
  struct Piece {
    Index triangle = no_index;             ///< no_index: there is none
    std::array<std::uint8_t, 3> corner{};  ///< its corners among the four points, counterclockwise
  };
  std::array<Point2, 4> points;
  std::array<Piece, 2> before;
  std::array<Piece, 3> after;
};

/// A place in a triangle.
struct Place {
  Index triangle;
  Barycentric b;
};

/// A straight piece of a way within one triangle.
struct Piece {
  Index triangle;
  Barycentric from, to;
};

/// How a triangulation came from another one: a record of every triangle there ever was, 0 to n - 1 being those of the
/// beginning, so that places and ways can be carried from one to the other. Nothing global is needed: each step is a
/// layout of four points, and errs by rounding of their size. Immutable but for `add`.
class Rearrangements {
 public:
  explicit Rearrangements(Index triangles = 0);

  /// Numbers the triangles of `after` (their `triangle` is ignored but for no_index) and returns the first number; the
  /// others follow.
  Index add(Rearrangement change);

  /// A place of the beginning in the triangulation of now. O(changes of its surroundings).
  Place locate(Place place) const;

  /// Appends the pieces, from `from` to `to`, of a straight way within a triangle of now, in triangles of the
  /// beginning. O(triangles there ever were along it).
  void restore(const Piece& way, std::vector<Piece>& out) const;

  std::size_t bytes() const;

 private:
  static Barycentric carry(const Rearrangement& change, const Rearrangement::Piece& from,
                           const Rearrangement::Piece& to, const Barycentric& b);
  void restore_flip(const Rearrangement& change, const Rearrangement::Piece& there, const Piece& way,
                    std::vector<Piece>& out) const;

  std::vector<Rearrangement> changes_;
  std::vector<Index> made_by_, replaced_by_;  ///< per triangle: a change, or no_index
};

}  // namespace geodrome::aleksandrov
