// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/jobs/compare/errors.hpp"
#include "geodrome/geometry.hpp"

namespace geodrome {

/// The statements of a solver on its distances D, and the means to judge them by the truth T.
struct GuaranteeTerms {
  double factor = 1;            ///< D <= factor T; +inf: none
  bool never_shorter = true;    ///< D >= T
  bool exact_truth = false;     ///< T is the exact distance on the surface of D
  std::vector<bool> of_source;  ///< whether it is stated for a source
  std::vector<bool> of_target;  ///< whether it is stated for a target
  double scale = 0;             ///< the largest distance, or coordinate
  double tolerance = 0;         ///< of `scale`: rounding, not error
};

struct GuaranteeFigures {
  std::optional<double> stated, worst;  ///< factor; the largest D / T among the pairs it is stated for
  std::optional<bool> held;             ///< none: nothing is stated, or the truth cannot judge it
  std::string why;                      ///< in words
};

/// The largest of the finite distances and, times the smallest weight of the faces, of the coordinates: no distance is
/// known better than these are rounded.
double scale_of(const DistanceRows& distances, std::span<const Vec3> positions, double smallest_weight);

/// Weighs the pairs for which the guarantee is stated and that both reach; those of no true distance too, but for
/// `worst`. Precondition: rows of the same shape, as long as `terms` says.
GuaranteeFigures judge_guarantee(const DistanceRows& distances, const DistanceRows& truth, const GuaranteeTerms& terms);

}  // namespace geodrome
