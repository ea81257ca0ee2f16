// SPDX-License-Identifier: MIT
#include <cmath>
#include <map>
#include <numbers>

#include "plugins/common/exact/exact_prepared.hpp"
#include "plugins/solver_chen_han/rows/direct_search.hpp"
#include "tests/plugins/solver_chen_han/rows_fixture.hpp"

/// What direct searches find, judged by the paths of plain searches.
namespace geodrome::test {
namespace {

using namespace chen_han;
using Kind = PackedMesh::VertexKind;

/// The first and last piece of a path that bends nowhere: points next to its two ends.
struct Straight {
  SurfacePoint first, last;
};

class DirectPathsOf {
 public:
  explicit DirectPathsOf(const MeshPtr& mesh)
      : prepared_(prepare_exact<Propagation>(mesh, {}, context_)),
        search_(prepared_->make_search()),
        surface_(mesh),
        ground_(surface_, {}, context_),
        direct_(surface_, {}, ground_) {
    for (Index v = 0; v < surface_.vertex_count(); ++v)
      if (surface_.kind(v) != Kind::smooth) bends_.push_back(v);
  }

  const PackedMesh& surface() const { return surface_; }
  const std::vector<Index>& bends() const { return bends_; }
  const CornerAngles& angles() const { return ground_.angles; }
  std::map<Index, FoundPath> paths(Index vertex) {
    std::map<Index, FoundPath> paths;
    for (const FoundPath& path : direct_.run(vertex, infinity, context_)) {
      const bool once = paths.emplace(path.target, path).second;
      EXPECT_TRUE(once) << path.target << " twice";
    }
    return paths;
  }

  /// Plain distances in packed units, by packed numbers.
  std::vector<double> plain(Index vertex) {
    const Source source{at(vertex), 0};
    map_ = &search_->run({&source, 1}, {.keep = Keep::map}, context_);
    std::vector<double> d(surface_.vertex_count());
    for (Index v = 0; v < d.size(); ++v)
      d[v] = std::ldexp(map_->vertices()[surface_.original_vertex(v)], surface_.exponent());
    return d;
  }
  /// Of the path to a vertex, from the source of the last `plain`: whether it passes a vertex at which paths can bend.
  bool bends_on_the_way(Index target, Straight& straight) {
    std::vector<SurfacePoint> path;
    map_->path(at(target), path);
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      const Index vertex = surface_.mesh().vertex_at(path[i]);
      if (vertex != no_index && surface_.kind(surface_.vertex_of_original(vertex)) != Kind::smooth) return true;
    }
    straight = {path[path.size() - 2], path[1]};
    return false;
  }
  /// The direction from a vertex to a point in a face beside it; NaN if the point's face is not beside it, or the point
  /// is a vertex.
  double direction(Index vertex, const SurfacePoint& point) const {
    double found = NAN;
    if (surface_.mesh().vertex_at(point) != no_index) return found;
    surface_.for_each_name(surface_.inner(point), [&](const SurfacePoint& name) {
      for (Index corner = 3 * name.face; corner < 3 * name.face + 3; ++corner) {
        if (surface_.from(corner) != vertex) continue;
        const auto [x, y] = surface_.in_frame(corner, name.b);
        found = ground_.angles.direction(corner, angle_of(x, std::max(0.0, y)));
      }
    });
    return found;
  }

 private:
  SurfacePoint at(Index vertex) const { return surface_.mesh().at_vertex(surface_.original_vertex(vertex)); }

  QuietContext context_;
  std::unique_ptr<PreparedSurface> prepared_;
  std::unique_ptr<Search> search_;
  PackedMesh surface_;
  DirectGround ground_;
  DirectSearch direct_;
  std::vector<Index> bends_;
  const ShortestPathMap* map_ = nullptr;
};

/// Without symmetries, so that no two paths are equally short.
std::vector<MeshPtr> meshes() {
  std::vector<MeshPtr> all;
  for (const MeshPtr& mesh : random_meshes(2)) all.push_back(shapes::small::shaken(mesh, 0.01, 5));
  all.push_back(shapes::small::terrain(14, 1, 3));
  all.push_back(shapes::small::bumpy_torus(16, 11, 0.15, 4));
  return all;
}

TEST(DirectPaths, AreAllShortestPathsThatBendNowhere) {
  for (const MeshPtr& mesh : meshes()) {
    DirectPathsOf direct(mesh);
    std::size_t straight = 0;
    for (std::size_t i = 0; i < direct.bends().size(); i += 5) {
      const Index source = direct.bends()[i];
      const std::vector<double> d = direct.plain(source);
      const auto paths = direct.paths(source);
      for (Index v = 0; v < d.size(); ++v) {
        Straight ends;
        if (v == source || direct.bends_on_the_way(v, ends)) continue;
        ++straight;
        ASSERT_TRUE(paths.contains(v)) << "from " << source << " to " << v;
        ASSERT_NEAR(paths.at(v).length, d[v], 1e-12 * d[v]);
      }
    }
    EXPECT_GT(straight, 100U);
  }
}

TEST(DirectPaths, HaveLengthsOfPathsThatExist) {
  for (const MeshPtr& mesh : meshes()) {
    DirectPathsOf direct(mesh);
    for (std::size_t i = 0; i < direct.bends().size(); i += 5) {
      const std::vector<double> d = direct.plain(direct.bends()[i]);
      for (const auto& [v, path] : direct.paths(direct.bends()[i])) ASSERT_GE(path.length, d[v] * (1 - 1e-12));
    }
  }
}

/// Codes are compared on the circle where directions go around the vertex.
void expect_direction(const DirectPathsOf& direct, Index vertex, DirectionCode code, double direction) {
  const double total = direct.angles().total(vertex);
  double apart = std::abs(code / double{full_angle} * total - direction);
  if (direct.surface().kind(vertex) == Kind::saddle) apart = std::min(apart, total - apart);
  EXPECT_LE(apart, 1e-4 + total / full_angle) << "at " << vertex;
}

TEST(DirectPaths, TellInWhichDirectionsTheyLeaveAndArrive) {
  for (const MeshPtr& mesh : meshes()) {
    DirectPathsOf direct(mesh);
    std::size_t judged = 0;
    for (std::size_t i = 0; i < direct.bends().size(); i += 5) {
      const Index source = direct.bends()[i];
      const std::vector<double> d = direct.plain(source);
      for (const auto& [v, path] : direct.paths(source)) {
        Straight ends;
        if (path.length > d[v] * (1 + 1e-12) || direct.bends_on_the_way(v, ends)) continue;
        const double exit = direct.direction(source, ends.first), arrival = direct.direction(v, ends.last);
        if (direct.angles().has_directions(source) && !std::isnan(exit))
          expect_direction(direct, source, path.exit, exit), ++judged;
        if (path.arrival < to_all_sides && !std::isnan(arrival))
          expect_direction(direct, v, path.arrival, arrival), ++judged;
      }
    }
    EXPECT_GT(judged, 100U);
  }
}

TEST(CornerAngles, AddUpAroundAVertex) {
  const PackedMesh grid(shapes::small::plane_grid(4));
  const CornerAngles angles(grid);
  for (Index v = 0; v < grid.vertex_count(); ++v) {
    double total = 0;
    for (const Index corner : grid.corners(v)) total += radians(angles.angle(corner));
    EXPECT_NEAR(angles.total(v), total, 1e-12);
    EXPECT_TRUE(std::abs(total - 2 * std::numbers::pi) < 1e-6 || total < std::numbers::pi + 1e-6);
    EXPECT_EQ(angles.start(grid.corners(v)[0]), Bearing{0});
  }
  const PackedMesh book(shapes::small::book());
  const CornerAngles unordered(book);
  for (const Index v : {0, 1}) EXPECT_FALSE(unordered.has_directions(book.vertex_of_original(v)));
}

TEST(Bearing, AddsWithoutRounding) {
  Bearing sum = 0;
  for (int i = 0; i < 30000; ++i) sum += bearing_of(1.1), sum -= bearing_of(1.1 - 1e-4);
  EXPECT_NEAR(radians(sum), 3, 1e-11);
  EXPECT_TRUE(is_known(sum));
  EXPECT_FALSE(is_known(sum + unknown_bearing));
  EXPECT_FALSE(is_known(sum + unknown_bearing + bearing_of(-2)));
}

}  // namespace
}  // namespace geodrome::test
