// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/common_gpl/planar_triangles.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "plugins/common/surfaces/finished_surface.hpp"
#include "plugins/common_gpl/guarded.hpp"

namespace geodrome {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Vec3 vec(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// How far points go along their main axis, across it, and off their plane.
struct Spread {
  PlaneFrame frame;
  double along = 0, across = 0, off_plane = 0;
};

Spread spread_of(std::span<const Vec3> points) {
  Vec3 centre;
  for (const Vec3& p : points) centre = centre + p / static_cast<double>(points.size());
  Spread spread;
  for (const Vec3& p : points) spread.along = std::max(spread.along, distance(p, centre));
  if (!(spread.along > 0)) return spread;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) {
    const Vec3 d = (p - centre) / spread.along;
    const Eigen::Vector3d v(d.x, d.y, d.z);
    covariance += v * v.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance);
  Eigen::Vector3d normal = axes.eigenvectors().col(0), x = axes.eigenvectors().col(2);
  Eigen::Index largest = 0;
  normal.cwiseAbs().maxCoeff(&largest);
  if (normal[largest] < 0) normal = -normal;
  spread.frame = {centre, vec(x), vec(normal.cross(x))};
  for (const Vec3& p : points) {
    const Vec3 d = p - centre;
    spread.off_plane = std::max(spread.off_plane, std::abs(dot(d, vec(normal))));
    spread.across = std::max(spread.across, norm(cross(d, vec(x))));
  }
  return spread;
}

}  // namespace

bool FaceRule::allows(Index a, Index b, Index c) const {
  const double ab = distance(points[a], points[b]), bc = distance(points[b], points[c]),
               ca = distance(points[c], points[a]);
  if (ab > edge_bound * std::min(psi[a], psi[b]) || bc > edge_bound * std::min(psi[b], psi[c]) ||
      ca > edge_bound * std::min(psi[c], psi[a]))
    return false;
  const double twice_area = norm(cross(points[b] - points[a], points[c] - points[a]));
  return !by_radius || ab * bc * ca <= 2 * twice_area * radius_bound * std::min({psi[a], psi[b], psi[c]});
}

std::optional<PlaneFrame> common_plane(std::span<const Vec3> points) {
  const Spread spread = spread_of(points);
  if (spread.across <= planar_tolerance * spread.along)
    throw SampleError("the kept points lie on a line", "a surface needs points that span at least a plane");
  if (spread.off_plane > planar_tolerance * spread.along) return std::nullopt;
  return spread.frame;
}

bool on_a_line(std::span<const Vec3> points) {
  const Spread spread = spread_of(points);
  return spread.across <= planar_tolerance * spread.along;
}

std::vector<Triangle> planar_surface(const PlaneFrame& frame, const FaceRule& rule, std::vector<Finding>& findings) {
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
  using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;
  std::vector<std::pair<Kernel::Point_2, Index>> flat;
  for (Index i = 0; i < rule.points.size(); ++i) {
    const Vec3 d = rule.points[i] - frame.origin;
    flat.emplace_back(Kernel::Point_2(dot(d, frame.x), dot(d, frame.y)), i);
  }
  return guarded([&] {
    const Delaunay delaunay(flat.begin(), flat.end());
    std::vector<Triangle> faces;
    std::size_t cut = 0;
    for (const auto& face : delaunay.finite_face_handles()) {
      const Triangle t{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
      if (rule.allows(t[0], t[1], t[2]))
        faces.push_back(t);
      else
        ++cut;
    }
    findings.push_back(finding(Finding::Severity::note, "planar",
                               "the sample, or a piece of it, is planar and was triangulated in its plane; " +
                                   counted(cut, "triangle", "triangles") + " too large for psi left out.",
                               cut));
    return faces;
  });
}

}  // namespace geodrome
