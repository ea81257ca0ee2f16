// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome {

/// A distance is a sum over the faces that a path crosses, seldom more than 1e4, each adding a few units in the last
/// place (2.2e-16 of the scale): below 1e-11, with a decade to spare.
inline constexpr double float64_tolerance = 1e-10;

/// An entry stored as float32 is off by at most 2^-24 of itself; the triangle inequality joins three of them.
inline constexpr double float32_tolerance = 0x1p-22;

/// A finished distance matrix and what its rows (sources) and columns (targets) stand for.
struct MatrixView {
  /// Row of the input that a matrix row or column belongs to. A source and a target are the same point if these are
  /// equal.
  std::span<const std::uint64_t> row_ids, column_ids;
  /// The points in space, in the units of the input; NaN for one without distances (dropped from the input).
  std::span<const Vec3> row_points, column_points;
  std::span<const double> starts;  ///< start distance per row; empty: all 0
  std::function<std::vector<double>(std::uint64_t row)> read;
};

struct InvariantOptions {
  double factor = 1;           ///< the solver's guarantee; +inf: symmetry and the triangle inequality are not expected
  bool one_surface = true;     ///< false if the surface changes with the source: they are not expected either
  bool bounded = true;         ///< false if nothing keeps distances from being below the straight line
  double smallest_weight = 1;  ///< of the faces: distances are at least this times the straight line
  double change = 0;           ///< how far each is at most from distances that obey; in the units of the input
  bool float32 = false;        ///< how the entries are stored
  double radius = infinity;    ///< the cut-off beyond which entries are +inf
  std::uint64_t entries = std::uint64_t{1} << 22;  ///< sampled rows hold at most so many (at least 3 rows)
  std::uint64_t triples = 200'000;
  std::uint64_t seed = 0;
};

/// The result of one check. A violation is positive where the invariant fails; it is relative to `Invariants::scale`.
struct InvariantCheck {
  bool expected = true;  ///< false: measured, but nothing promises it
  double tolerance = 0;
  std::uint64_t tested = 0, violated = 0;  ///< violated: by more than the tolerance
  double worst = -infinity;                ///< greatest violation; below 0: the margin
  /// Where the worst is: rows and columns of the matrix, from 0. Meaningless if nothing was tested.
  std::uint64_t row = 0, column = 0;
  std::uint64_t middle = 0;  ///< triangle: the matrix row of the point on the way

  bool holds() const noexcept { return !expected || violated == 0; }
};

struct Invariants {
  std::uint64_t rows = 0;                                     ///< sampled; all of them if the matrix is small
  std::uint64_t entries = 0, infinite = 0, not_computed = 0;  ///< in the sampled rows
  double scale = 0;         ///< largest finite distance, or coordinate times the smallest weight, in the sampled rows
  InvariantCheck computed;  ///< no NaN between points that have distances; worst is 1 where there is one
  InvariantCheck identity;  ///< D(s, s) is the start distance: |D(s, s) - start|
  InvariantCheck euclid;    ///< not below the straight line: smallest_weight |st| - D(s, t)
  InvariantCheck symmetry;  ///< D(s, t) - factor D(t, s)
  InvariantCheck triangle;  ///< D(s, u) - factor (D(s, t) + D(t, u))

  bool holds() const noexcept {
    return computed.holds() && identity.holds() && euclid.holds() && symmetry.holds() && triangle.holds();
  }
};

/// Checks what holds for distances on any surface, on a seeded sample: every entry of the sampled rows, all pairs of
/// sampled rows, random triples of two sampled rows and any column. Distances are taken without their start.
/// Precondition: spans as long as the matrix has rows and columns. O(options.entries + options.triples) and one `read`
/// per sampled row; the sampled rows are in memory together.
Invariants check_invariants(const MatrixView& matrix, const InvariantOptions& options = {});

}  // namespace geodrome
