// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "engine/checks/distance_audit.hpp"
#include "engine/search/prepared_solver.hpp"
#include "engine/surface/common_face.hpp"

namespace geodrome {

/// Holds distances that were given against what is known about them, and keeps the worst violation. Where a factor is
/// involved it is the solver's, and only targets of which the solver promises it are judged.
class DistanceJudge {
 public:
  /// All must outlive it.
  DistanceJudge(const PreparedSolver& solver, const SurfaceMesh& mesh, const GivenDistances& given);

  /// Sources on the surface; targets there of which the factor is promised.
  std::span<const Index> sources() const { return sources_; }
  std::span<const Index> targets() const { return targets_; }
  const NamedPoint& source(Index i) const { return given_.sources[i]; }
  const NamedPoint& target(Index j) const { return given_.targets.named()[j]; }
  const Distance& given(Index j) const { return given_.distances[j]; }
  /// The start distance of a row, which its search does not know.
  double offset() const { return offset_; }
  double scale() const { return scale_; }

  /// The factor holds for all that the very search found at vertices.
  bool promises_all() const;

  /// `other` is the length of a way to target j by this solver, at most `factor` times the shortest. `whose()` words
  /// it.
  template <class Words>
  void not_longer_than(Index j, double other, Words&& whose) {
    const double value = given(j).value, bound = std::max(factor_ * other, least(j));
    if (bound == infinity) return;
    if (value != infinity) return report(value - (1 + given_.rounding) * bound, j, whose, other);
    // Beyond the limit: of a cloud the straight line from a source that is not named may be what lies there.
    const bool named = given(j).source < given_.sources.size();
    if (!given_.targets.bounded() || named) report(given_.max_distance - bound, j, whose, other);
  }

  /// `other` is what another search gives for the very source that is named; it looked no farther than `radius`.
  template <class Words>
  void not_shorter_than(Index j, double other, double radius, Words&& whose) {
    const double at_least = other == infinity ? radius : other;
    if (given(j).value < infinity)
      report(at_least - (factor_ + given_.rounding) * given(j).value, j, whose, other);
  }

  /// No distance is below the straight line.
  void check_straight_lines();
  /// What the very search found at the vertices: around the sources it is not longer than the straight way, and the
  /// given distances are the same there, and Lipschitz with it in faces.
  void check_vertices(std::span<const double> vertices);

  /// What was found, relative to the scale.
  DistanceAudit result() const;

 private:
  double least(Index j) const;

  template <class Words>
  void report(double violation, Index j, Words&& whose, double other) {
    if (!is_worse(violation)) return;
    const bool named = given(j).source < given_.sources.size();
    where_ = "target " + target(j).label + " is given " + text(given(j).value) +
             (named ? " from source " + source(given(j).source).label : "") + ", but " + whose() + " " + text(other);
  }
  /// Keeps the worst violation; one that is no number is worse than all.
  bool is_worse(double violation);
  static std::string text(double value);

  void check_starts(std::span<const double> vertices);
  void check_targets(std::span<const double> vertices);

  /// The vertices that a straight way in the place's face leads to, and its cost: of a vertex itself alone.
  template <class Visit>
  void for_corners(const Place& place, Visit&& visit) const {
    if (place.vertex != no_index) return visit(place.vertex, 0.0);
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<double, 3> corner{};
      corner[i] = 1;
      visit(mesh_.triangles()[place.at.face][i], straight_within(mesh_, place.at.face, place.at.b, corner));
    }
  }

  const PreparedSolver& solver_;
  const SurfaceMesh& mesh_;
  const GivenDistances& given_;
  double factor_, smallest_weight_, offset_ = 0, scale_ = 0, worst_ = 0;
  std::vector<Index> sources_, targets_;
  std::string where_;
};

}  // namespace geodrome
