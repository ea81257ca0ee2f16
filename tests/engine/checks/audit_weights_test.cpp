// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/surface/common_face.hpp"
#include "geodrome/engine/audit.hpp"
#include "tests/support/falsified_map.hpp"

namespace geodrome {
namespace {

using test::FalsifiedMap;

constexpr double rounding = 1e-12, caught = 1e-3;
constexpr Provides everything =
    Provides::any_point | Provides::paths | Provides::path_is_distance | Provides::factor_any_point;
constexpr double dear = 4;

/// The unit square, cut along x = y into a cheap half below (weight 1) and a dear one above (weight 4).
MeshPtr square(bool dear_first) {
  std::vector<Triangle> faces{{0, 1, 2}, {0, 2, 3}};
  std::vector<double> weights{1, dear};
  if (dear_first) std::ranges::reverse(faces), std::ranges::reverse(weights);
  return std::make_shared<const SurfaceMesh>(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, faces,
                                             weights);
}

/// The same without weights.
MeshPtr unweighted(const SurfaceMesh& mesh) {
  return std::make_shared<const SurfaceMesh>(std::vector<Vec3>(mesh.positions().begin(), mesh.positions().end()),
                                             std::vector<Triangle>(mesh.triangles().begin(), mesh.triangles().end()));
}

/// True distances from vertex 0: straight below; above along the cut, leaving it at the critical angle.
class SquareMap : public ShortestPathMap {
 public:
  explicit SquareMap(MeshPtr mesh) : mesh_(std::move(mesh)) {
    for (Index v = 0; v < 4; ++v) vertices_.push_back(at(mesh_->at_vertex(v)).value);
  }

  std::span<const double> vertices() const override { return vertices_; }
  Distance at(const SurfacePoint& point) const override {
    const auto [along, off] = from_cut(point);
    const double value = off > 0 ? along + off * std::sqrt(dear * dear - 1) : std::hypot(along, off);
    return {value, Reach::reached, 0};
  }
  void path(const SurfacePoint& point, std::vector<SurfacePoint>& out) const override {
    out = {point};
    const auto [along, off] = from_cut(point);
    if (off > 0) out.push_back(on_cut((along - off / std::sqrt(dear * dear - 1)) / std::sqrt(2)));
    out.push_back(mesh_->at_vertex(0));
  }
  std::span<const Counter> counters() const override { return {}; }

 private:
  /// Coordinates along the cut and off it; above it the second is positive, on it exactly 0.
  std::pair<double, double> from_cut(const SurfacePoint& point) const {
    const Vec3 p = mesh_->position(point);
    return {(p.x + p.y) / std::sqrt(2), (p.y - p.x) / std::sqrt(2)};
  }
  SurfacePoint on_cut(double share) const {
    SurfacePoint point{0, {}};
    for (int i = 0; i < 3; ++i) {
      if (mesh_->triangles()[0][i] == 0) point.b[i] = 1 - share;
      if (mesh_->triangles()[0][i] == 2) point.b[i] = share;
    }
    return point;
  }

  MeshPtr mesh_;
  std::vector<double> vertices_;
};

class AuditWeights : public testing::TestWithParam<bool> {
 protected:
  AuditResult audit_on(const SurfaceMesh& mesh, const ShortestPathMap& map) const {
    const Source source{mesh.at_vertex(0), 0};
    return audit(mesh, {&source, 1}, map, everything, {});
  }
  AuditResult audit_scaled(double scale) const {
    const auto change = [scale](const SurfacePoint&, Distance right) { return right.value *= scale, right; };
    return audit_on(*mesh_, FalsifiedMap(map_, change));
  }

  MeshPtr mesh_ = square(GetParam());
  SquareMap map_{mesh_};
};

INSTANTIATE_TEST_SUITE_P(DearFaceFirst, AuditWeights, testing::Bool());

TEST_P(AuditWeights, FindsNoFaultInTrueDistances) {
  const AuditResult result = audit_on(*mesh_, map_);
  EXPECT_LT(result.worst_lipschitz, rounding) << result.where;
  EXPECT_LT(result.worst_path, rounding) << result.where;
  EXPECT_GT(result.paths, 0u);
}

TEST_P(AuditWeights, AreWhatMakesThoseDistancesRight) {
  const AuditResult result = audit_on(*unweighted(*mesh_), map_);
  EXPECT_GT(result.worst_lipschitz, caught);
  EXPECT_GT(result.worst_path, caught);
}

TEST_P(AuditWeights, CatchesDistancesThatAreTooLong) { EXPECT_GT(audit_scaled(1.02).worst_lipschitz, caught); }

TEST_P(AuditWeights, CatchesDistancesThatAreTooShort) { EXPECT_GT(audit_scaled(0.98).worst_path, caught); }

TEST_P(AuditWeights, AnEdgeCostsAsMuchAsItsCheaperFace) {
  const CommonFace common(*mesh_);
  EXPECT_DOUBLE_EQ(common.straight(mesh_->at_vertex(0), mesh_->at_vertex(2)).value(), std::sqrt(2));
  EXPECT_DOUBLE_EQ(common.straight(mesh_->at_vertex(0), mesh_->at_vertex(3)).value(), dear);
}

}  // namespace
}  // namespace geodrome
