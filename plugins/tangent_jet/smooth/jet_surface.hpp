// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "geodrome/smooth_surface.hpp"
#include "plugins/tangent_jet/smooth/quartic.hpp"

namespace geodrome {

/// The smooth surface that quartics at the vertices of a mesh make: a point p of the plane of a face, with barycentric
/// coordinates b, goes to
///
///     S = p + sum_i w_i h_i n_i,   w_i = b_i^2 / (b_0^2 + b_1^2 + b_2^2),
///
/// h_i n_i being the way from p along the normal of corner i to its quartic. On an edge only its two corners count, and
/// at a vertex its own: so S is continuous across edges and takes each vertex to its quartic above it.
class JetSurface final : public SmoothSurface {
 public:
  /// One quartic per vertex, one deviation per face.
  JetSurface(MeshPtr mesh, std::vector<Quartic> quartics, std::vector<double> deviations)
      : mesh_(std::move(mesh)), quartics_(std::move(quartics)), deviations_(std::move(deviations)) {}

  double deviation(Index face) const override { return deviations_[face]; }
  void evaluate(std::span<const SmoothPlace> places, std::span<SmoothPoint> points) const override;
  std::size_t bytes() const override;

 private:
  MeshPtr mesh_;
  std::vector<Quartic> quartics_;
  std::vector<double> deviations_;
};

}  // namespace geodrome
