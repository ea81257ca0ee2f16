// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "plugins/solver_heat/surface_parts.hpp"

namespace geodrome {

/// The heat method on one component: its two linear systems, factored. The only part that includes CGAL.
/// Not to be used by two threads at once.
class HeatSystem {
 public:
  /// `part` is kept by reference. Throws NumericalError for a face that is too flat and for what CGAL fails on.
  explicit HeatSystem(const SurfacePart& part);
  ~HeatSystem();
  HeatSystem(const HeatSystem&) = delete;
  HeatSystem& operator=(const HeatSystem&) = delete;

  /// The distances of all vertices of the part from one of them, in lengths of the mesh: 0 at the source, none
  /// negative. The same whatever was asked before. Throws NumericalError for what cannot be distances: no numbers,
  /// beyond the reach of heat, or rising along an edge by four times its length.
  const std::vector<double>& from(Index source);

 private:
  struct Cgal;

  const SurfacePart& part_;
  std::unique_ptr<Cgal> cgal_;
  std::vector<double> distances_;
};

}  // namespace geodrome
