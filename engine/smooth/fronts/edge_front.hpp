// SPDX-License-Identifier: MIT
#pragma once

#include "engine/smooth/fronts/edge_curves.hpp"
#include "engine/smooth/fronts/front_point.hpp"

namespace geodrome {

/// The distance along the curve of an edge, from what is known at its two ends: its square as a polynomial of degree 5
/// in the share of the edge, for squares of distances are smooth at the source too. Off by the sixth power of the edge.
class EdgeFront {
 public:
  /// Precondition: fronts go on from both ends.
  EdgeFront(const EdgeCurve& curve, const FrontPoint& from, const FrontPoint& to);

  const EdgeCurve& curve() const { return *curve_; }
  /// By how much the polynomials of degree 5 and 3 differ in the middle, as a distance over the length of the edge. It
  /// is large where the ends are reached by different ways.
  double doubt() const { return doubt_; }

  struct Slopes {
    double value, first, second;  ///< of the distance, by the share of the edge
  };
  Slopes at(double share) const;

  /// Between those at the ends: it tells on which side of the edge the source is.
  Vec3 gradient(double share) const { return (1 - share) * from_ + share * to_; }

 private:
  const EdgeCurve* curve_;
  std::array<double, 6> squared_;
  double doubt_;
  Vec3 from_, to_;
};

}  // namespace geodrome
