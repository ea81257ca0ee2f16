// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "geodrome/engine/pipeline.hpp"

namespace geodrome {

/// A value measured at one sample point.
struct PlacedValue {
  Index point = no_index;
  double measured = 0;
};

/// A bound, what was measured, and where it is strained most.
struct Claim {
  enum class Sense { at_most, at_least };

  std::string code;          ///< stable, for programs: "edge_to_psi"
  std::string name, source;  ///< "edge length over psi <= 4.112", "Lemma 9"
  Sense sense = Sense::at_most;
  double bound = 0;
  double measured = std::numeric_limits<double>::quiet_NaN();  ///< the worst; NaN: not measured
  std::string not_measured;                                    ///< then: why
  std::vector<PlacedValue> places;                             ///< at most one value per point, worst first
  bool strain_tells = true;  ///< false: held near its bound by construction, so that only a failure says something

  bool is_measured() const { return !std::isnan(measured); }
  /// Returns the share of the bound that a value uses up; above 1 the value breaks the bound.
  double strain(double value) const { return sense == Sense::at_most ? value / bound : bound / value; }
  bool holds() const { return is_measured() && strain(measured) <= 1; }
  bool fails() const { return is_measured() && strain(measured) > 1; }
};

/// Measures the statements that the paper proves of the surface for epsilon <= 1/22: psi is 1/18-Lipschitz (over the
/// surface's edges and 10,000 seeded random pairs), Lemma 6 (as the decimator measured it, and over the edges), Lemmas
/// 9, 12, 14 and 15, and the circumradius of faces, which Lemma 8 bounds: the surface point over a face's circumcentre
/// is equally far from the corners, and as far from every other kept point or farther. Without a surface most is not
/// measured. O(n log n).
std::vector<Claim> claims_of(const PlacedSurface& surface, std::uint64_t seed);

/// Smooth shapes come out right up to the first epsilon, and mostly up to the second: observed on some 300 samples, not
/// proven.
inline constexpr double good_epsilon = 0.3, fair_epsilon = 0.5;

/// phi over the radius of curvature, which no local feature size exceeds: epsilon as far as two kept points that are
/// neighbours (each with its six nearest) show it, whose tangent planes turn by 2 asin(distance / (2 radius)). Needs no
/// surface. Bound: `good_epsilon`.
Claim claim_curvature(const PlacedSurface& surface);

/// Epsilon as claim_curvature shows it, on a surface with a boundary only between points whose state is `ok`, if nine
/// of ten kept points are. On a rim phi reaches past the surface, and the planes of points nearer to each other than
/// psi, which only a rim keeps, turn by their noise. NaN if no points were kept.
double least_epsilon(const PlacedSurface& surface);

/// Every live point of the input nearer to the surface than its psi. No bound of the paper: a point farther off than
/// the spacing of the sample is not represented by the surface.
Claim claim_points_on_surface(const Input& input, const PlacedSurface& surface);

}  // namespace geodrome
