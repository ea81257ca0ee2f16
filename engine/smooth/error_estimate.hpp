// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "geodrome/smooth_surface.hpp"

/// How far the length of a curve may be off that is measured on a smooth surface, and on flat faces where that is not
/// trusted: an estimate, no bound. engine/README.md, "How accurate the distances are", has what it is worth.
namespace geodrome {

/// The estimate of one length, summed up piece by piece, in any order.
class LengthError {
 public:
  /// A piece on the smooth surface. Where that is lifted by d, a curve gains d times the angle by which its normal
  /// turns. Lifts a spacing apart are up or down by chance, so that squares add up.
  /// `expected`: of its face, see `expected_errors`. `spacings`: its length over a mean edge of its face, above 0.
  void add_smooth(double expected, double turn, double spacings) {
    variance_ += expected * expected * turn * turn / spacings;
  }

  /// A flat piece, along which the normals of the faces turn by so much. All of them are off to one side where what
  /// was sampled is round, so that errors themselves add up.
  void add_flat(double length, double turn) { common_ += flat_share * length * turn * turn; }

  /// By how much a length changed when it was extrapolated from every second node.
  void add_extrapolation(double change) { common_ += left_share * std::abs(change); }

  /// By how much a length is estimated to be off because it was carried from place to place.
  void add_carried(double change) { common_ += change; }

  /// The estimate of a length between two others, at a share of the way from `a` to `b`.
  static LengthError between(const LengthError& a, const LengthError& b, double share) {
    LengthError mixed;
    mixed.variance_ = (1 - share) * a.variance_ + share * b.variance_;
    mixed.common_ = (1 - share) * a.common_ + share * b.common_;
    return mixed;
  }

  double value() const { return std::sqrt(variance_ + common_ * common_); }

 private:
  /// Chords of an arc whose directions differ by t are too short by t^2 / 24 of it. Faces lie lower than chords, but
  /// on surfaces of samples their normals turn to and fro as well: faces were off by 0.025 to 0.09 t^2. Where all
  /// triangles are alike, as on a mesh of a sphere from an icosahedron, it is up to 0.3.
  static constexpr double flat_share = 0.1;
  /// What extrapolation leaves is of a higher order.
  static constexpr double left_share = 0.1;

  double variance_ = 0;  // of what is up or down by chance
  double common_ = 0;    // the sum of all else
};

/// What a smooth surface is expected to be off over each face, in the mean along a curve; infinite where it is not
/// trusted. `deviations`: what it states, face by face; infinite for faces without an area. O(F).
std::vector<double> expected_errors(const SurfaceMesh& mesh, const SmoothSurface& surface,
                                    std::span<const double> deviations);

}  // namespace geodrome
