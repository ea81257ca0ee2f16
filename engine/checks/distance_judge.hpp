// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/checks/distance_audit.hpp"
#include "engine/search/prepared_solver.hpp"

namespace geodrome {

/// Holds distances that were given against what is known about them, and keeps the worst violation. Only targets of
/// which the solver promises its factor are judged. `words`: of what was found instead, for people.
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
  /// The largest distance or coordinate.
  double scale() const { return scale_; }

  /// `other` is the length of a way to target j by this solver, at most `factor` times the shortest.
  void not_longer_than(Index j, double other, std::string_view words);
  /// `other` is what another search gives for the very source that is named; it looked no farther than `radius`.
  void not_shorter_than(Index j, double other, double radius, std::string_view words);
  /// No distance is below the straight line.
  void check_straight_lines();
  /// What the very search found at the vertices, if the factor holds for all of it: around the sources it is no longer
  /// than the straight way, and the given distances are the same there, and fit it in faces.
  void check_vertices(std::span<const double> vertices);

  /// The worst violation, relative to the scale.
  DistanceAudit result() const;

 private:
  double least(Index j) const;
  void report(double violation, Index j, double other, std::string_view words);
  bool is_worse(double violation);

  const PreparedSolver& solver_;
  const SurfaceMesh& mesh_;
  const GivenDistances& given_;
  double factor_, smallest_weight_, offset_ = 0, scale_ = 0, worst_ = 0;
  std::vector<Index> sources_, targets_;
  std::string where_;
};

}  // namespace geodrome
