// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/reconstructor_advancing_front/advancing_front.hpp"

#include <utility>

#include "plugins/common/surfaces/manifold_faces.hpp"
#include "plugins/reconstructor_advancing_front/front_triangles.hpp"

namespace geodrome {

Reconstruction AdvancingFront::reconstruct(const PointSample& sample, const Tangents& tangents, const Control& control,
                                           std::span<const Index> kept, RunContext& context) const {
  context.throw_if_cancelled();
  const KeptPoints points = kept_points(sample, tangents, control, kept);
  Reconstruction result;
  const auto plane = common_plane(points.points);
  const FaceRule rule{points.points, points.psi, plane || settings_.boundary != BoundaryRule::closed};
  std::vector<Triangle> faces = plane ? planar_surface(*plane, rule, result.findings) : front_triangles(rule);
  context.throw_if_cancelled();
  const std::size_t dropped = drop_minor_fans(faces, points.points.size());
  if (dropped > 0)
    result.findings.push_back(
        finding(Finding::Severity::warning, "dropped_faces",
                counted(dropped, "face", "faces") + " met the rest in a single point and left out.", dropped));
  orient_outwards(faces, points.points);
  finish(result, std::move(faces), points, sample, settings_.boundary);
  return result;
}

}  // namespace geodrome
