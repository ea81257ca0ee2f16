// SPDX-License-Identifier: MIT
#include "plugins/common/surfaces/surface_inserter.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "interfaces/internal/closest_point_tree.hpp"
#include "plugins/common/surfaces/point_insertion.hpp"

namespace geodrome {
namespace {

/// A point nearer to a vertex than this share of the longest edge there has no triangle with it in double precision.
constexpr double coincident = 1e-9;

/// Returns the vertex of a face that a point coincides with, or no_index.
Index coincident_vertex(const SurfaceMesh& mesh, Index face, const Vec3& point) {
  const auto [p, q, r] = mesh.corners(face);
  const double longest2 = std::max({squared_distance(p, q), squared_distance(q, r), squared_distance(r, p)});
  for (const Index v : mesh.triangles()[face])
    if (squared_distance(point, mesh.positions()[v]) <= coincident * coincident * longest2) return v;
  return no_index;
}

MeshPtr changed(const SurfaceMesh& mesh, const Vec3& point, const LocalChange& change) {
  std::vector<Vec3> positions;
  positions.reserve(mesh.vertex_count() + 1);
  positions.assign(mesh.positions().begin(), mesh.positions().end());
  positions.push_back(point);
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.face_count() + change.added.size());
  triangles.assign(mesh.triangles().begin(), mesh.triangles().end());
  for (const auto& [face, corners] : change.replaced) triangles[face] = corners;
  triangles.insert(triangles.end(), change.added.begin(), change.added.end());
  return std::make_shared<const SurfaceMesh>(std::move(positions), std::move(triangles));
}

class SurfaceInserter final : public PointInserter {
 public:
  SurfaceInserter(MeshPtr mesh, const std::vector<Index>& sample_of_vertex, const PointSample& sample)
      : mesh_(std::move(mesh)), tree_(mesh_), points_(sample.points), vertex_of_sample_(sample.size(), no_index) {
    for (Index v = 0; v < sample_of_vertex.size(); ++v)
      if (sample_of_vertex[v] != no_index) vertex_of_sample_[sample_of_vertex[v]] = v;
  }

  Inserted with(Index sample) const override {
    if (sample >= points_.size() || !is_finite(points_[sample]))
      throw SampleError("sample point " + std::to_string(sample) + " cannot be inserted: it is no point of the sample");
    if (const Index v = vertex_of_sample_[sample]; v != no_index) return {mesh_, v, Insertion::existing};
    const Vec3& point = points_[sample];
    const SurfacePoint closest = tree_.closest(point).at();
    if (const Index v = coincident_vertex(*mesh_, closest.face, point); v != no_index)
      return {mesh_, v, Insertion::existing};
    const LocalChange change = insert_point(*mesh_, point, closest);
    return {changed(*mesh_, point, change), static_cast<Index>(mesh_->vertex_count()), change.how};
  }

 private:
  MeshPtr mesh_;
  detail::ClosestPointTree tree_;
  std::vector<Vec3> points_;
  std::vector<Index> vertex_of_sample_;
};

}  // namespace

std::unique_ptr<PointInserter> make_inserter(MeshPtr mesh, const std::vector<Index>& sample_of_vertex,
                                             const PointSample& sample) {
  return std::make_unique<SurfaceInserter>(std::move(mesh), sample_of_vertex, sample);
}

}  // namespace geodrome
