// SPDX-License-Identifier: MIT
#include "geodrome/engine/audit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/surface/common_face.hpp"
#include "tests/support/discovered.hpp"
#include "tests/support/falsified_map.hpp"
#include "tests/support/meshes.hpp"

namespace geodrome {
namespace {

using namespace test;

constexpr double rounding = 1e-12;  ///< what a right map may show, relative to the largest distance
constexpr double caught = 1e-9;     ///< what a fault must show at least

constexpr Provides everything =
    Provides::any_point | Provides::paths | Provides::path_is_distance | Provides::factor_any_point;
constexpr Provides paths_of_any_length = Provides::any_point | Provides::paths;
constexpr Provides no_paths = Provides::any_point;

const Discovered<ShortestPathSolver>& exact_solver() {
  static const auto all = discovered<ShortestPathSolver>();
  return *std::ranges::find(all, "cgal", &Discovered<ShortestPathSolver>::name);
}

/// An exact map, with everything it needs kept alive.
struct Exact {
  MeshPtr mesh;
  std::vector<Source> sources;
  QuietContext context;
  std::unique_ptr<PreparedSurface> prepared;
  std::unique_ptr<Search> search;
  const ShortestPathMap* map;

  Exact(MeshPtr on, std::vector<Source> from)
      : mesh(std::move(on)),
        sources(std::move(from)),
        prepared(exact_solver().object->prepare(mesh, context)),
        search(prepared->make_search()),
        map(&search->run(sources, {.keep = Keep::map}, context)) {}

  AuditResult audit(const ShortestPathMap& of, Provides provides, double factor = 1) const {
    return geodrome::audit(*mesh, sources, of, provides, {.factor = factor});
  }
  AuditResult audit_changed(Provides provides, FalsifiedMap::ChangeDistance distance,
                            FalsifiedMap::ChangePath path = {}) const {
    return audit(FalsifiedMap(*map, std::move(distance), std::move(path)), provides);
  }
};

struct Case {
  const char* name;
  std::function<Exact()> make;
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

Exact on_torus() {
  const MeshPtr mesh = bumpy_torus(9, 7, 0.1, 4);
  return {mesh, {{mesh->at_vertex(10), 0}}};
}

Exact on_terrain() {
  const MeshPtr mesh = terrain(6, 0.4, 8);
  return {mesh, {{{20, {0.5, 0.2, 0.3}}, 0}, {mesh->at_vertex(0), 0}}};
}

Exact on_two_components() {
  const MeshPtr mesh = both(terrain(4, 0.7, 2), bumpy_torus(7, 5, 0.05, 3));
  return {mesh, {{mesh->at_vertex(30), 0}}};
}

class AuditTest : public testing::TestWithParam<Case> {
 protected:
  /// One made for each case, not for each test: the search is the slow part.
  const Exact& exact() const {
    static std::map<std::string, std::unique_ptr<const Exact>> made;
    auto& one = made[GetParam().name];
    if (!one) one.reset(new Exact(GetParam().make()));
    return *one;
  }
};

INSTANTIATE_TEST_SUITE_P(Audit, AuditTest,
                         testing::Values(Case{"bumpy_torus", on_torus}, Case{"bordered_terrain", on_terrain},
                                         Case{"two_components", on_two_components}),
                         [](const auto& test) { return std::string(test.param.name); });

Distance times(double factor, Distance distance) { return distance.value *= factor, distance; }

/// How near a point is to a vertex: 1 there, 0 on all edges that do not end there.
double nearness(const SurfaceMesh& mesh, const SurfacePoint& point, Index vertex) {
  const Triangle& corners = mesh.triangles()[point.face];
  const auto corner = std::ranges::find(corners, vertex) - corners.begin();
  return corner == 3 ? 0 : point.b[corner];
}

/// Vertices that the search reached, but no sources: every third.
std::vector<Index> some_vertices(const Exact& exact) {
  std::vector<Index> result;
  for (Index v = 0; v < exact.mesh->vertex_count(); v += 3)
    if (std::isfinite(exact.map->vertices()[v]) && exact.map->vertices()[v] > 0) result.push_back(v);
  return result;
}

double largest_distance(const Exact& exact) {
  double largest = 0;
  for (const double d : exact.map->vertices())
    if (std::isfinite(d)) largest = std::max(largest, d);
  return largest;
}

/// A face without a source, in a component with one.
Index reached_face(const Exact& exact) {
  const Triangle* triangles = exact.mesh->triangles().data();
  for (Index f = static_cast<Index>(exact.mesh->face_count()); f-- > 0;)
    if (std::ranges::all_of(triangles[f], [&](Index v) {
          return std::isfinite(exact.map->vertices()[v]) && exact.map->vertices()[v] > 0;
        }))
      return f;
  return no_index;
}

TEST_P(AuditTest, FindsNoFaultInARightMap) {
  const AuditResult result = exact().audit(*exact().map, everything);
  EXPECT_LT(result.worst_lipschitz, rounding) << result.where;
  EXPECT_LT(result.worst_path, rounding) << result.where;
}

TEST_P(AuditTest, LooksAtEveryFace) {
  EXPECT_EQ(exact().audit(*exact().map, everything).faces, exact().mesh->face_count());
}

TEST_P(AuditTest, MeasuresViolationsByTheLargestDistance) {
  const AuditResult result = exact().audit(*exact().map, everything);
  EXPECT_GE(result.scale, largest_distance(exact()));
  EXPECT_LT(result.scale, 1.5 * largest_distance(exact()));  // it may lie on an edge
}

TEST_P(AuditTest, CatchesAMillionthTooMuchAroundOneVertexByItsPath) {
  for (const Index v : some_vertices(exact())) {
    const AuditResult result = exact().audit_changed(everything, [&](const SurfacePoint& point, Distance distance) {
      return distance.value += 1e-6 * nearness(*exact().mesh, point, v), distance;
    });
    EXPECT_GT(result.worst_path, caught) << "vertex " << v;
  }
}

TEST_P(AuditTest, CatchesAMillionthTooMuchAroundOneVertexByTheLipschitzBound) {
  for (const Index v : some_vertices(exact())) {
    const AuditResult result =
        exact().audit_changed(paths_of_any_length, [&](const SurfacePoint& point, Distance distance) {
          return distance.value += 1e-6 * nearness(*exact().mesh, point, v), distance;
        });
    EXPECT_GT(result.worst_lipschitz, caught) << "vertex " << v;
  }
}

TEST_P(AuditTest, CatchesDistancesTwoPercentTooLong) {
  const auto longer = [](const SurfacePoint&, Distance distance) { return times(1.02, distance); };
  EXPECT_GT(exact().audit_changed(paths_of_any_length, longer).worst_lipschitz, caught);
}

TEST_P(AuditTest, CatchesDistancesTwoPercentTooShort) {
  const auto shorter = [](const SurfacePoint&, Distance distance) { return times(0.98, distance); };
  EXPECT_GT(exact().audit_changed(everything, shorter).worst_path, caught);
}

TEST_P(AuditTest, CatchesPathsThatEndBeforeTheSource) {
  const auto cut = [](std::vector<SurfacePoint>& path) {
    if (path.size() > 2) path.pop_back();
  };
  EXPECT_GT(exact().audit_changed(everything, {}, cut).worst_path, caught);
}

TEST_P(AuditTest, CatchesPathsThatBeginElsewhere) {
  const auto cut = [](std::vector<SurfacePoint>& path) {
    if (path.size() > 2) path.erase(path.begin());
  };
  EXPECT_GT(exact().audit_changed(everything, {}, cut).worst_path, caught);
}

TEST_P(AuditTest, CatchesAPathThatJumpsOverAFace) {
  const auto jump = [](std::vector<SurfacePoint>& path) {
    if (path.size() > 4) path.erase(path.begin() + 2, path.begin() + 3);
  };
  EXPECT_EQ(exact().audit_changed(paths_of_any_length, {}, jump).worst_path, infinity);
}

TEST_P(AuditTest, CatchesAMissingPath) {
  const auto none = [](std::vector<SurfacePoint>& path) { path.clear(); };
  EXPECT_EQ(exact().audit_changed(paths_of_any_length, {}, none).worst_path, infinity);
}

TEST_P(AuditTest, CatchesASourceThatIsNotThere) {
  const auto other = [](const SurfacePoint&, Distance distance) {
    if (distance.reach == Reach::reached) distance.source = 7;
    return distance;
  };
  EXPECT_EQ(exact().audit_changed(paths_of_any_length, other).worst_path, infinity);
}

TEST_P(AuditTest, CatchesAnythingElseThanADistanceAtAPointThatIsReached) {
  const Index face = reached_face(exact());
  for (const Distance wrong : {Distance{infinity, Reach::unreachable, no_index}, Distance{infinity, Reach::reached, 0},
                               Distance{std::nan(""), Reach::reached, 0}, Distance{1, Reach::beyond_limit, 0}}) {
    const AuditResult result = exact().audit_changed(
        everything, [&](const SurfacePoint& point, Distance right) { return point.face == face ? wrong : right; });
    EXPECT_EQ(result.worst_lipschitz, infinity) << wrong.value << ", reach " << int(wrong.reach);
  }
}

TEST_P(AuditTest, CatchesAHalfPlaneThatIsTooLong) {
  // As if no window had come past x = 0.6: longer the farther behind it, without a jump.
  const auto behind = [&](const SurfacePoint& point) { return std::max(0.0, exact().mesh->position(point).x - 0.6); };
  const auto longer = [&](const SurfacePoint& point, Distance distance) {
    return distance.value += 1e-4 * behind(point), distance;
  };
  EXPECT_GT(exact().audit_changed(paths_of_any_length, longer).worst_lipschitz, caught);
}

TEST_P(AuditTest, NamesAFaceAndAPlaceOfTheFault) {
  const Index vertex = some_vertices(exact()).back();
  const AuditResult result = exact().audit_changed(paths_of_any_length, [&](const SurfacePoint& point, Distance right) {
    return right.value += 1e-3 * nearness(*exact().mesh, point, vertex), right;
  });
  ASSERT_NE(result.worst_lipschitz_face, no_index);
  const Triangle& corners = exact().mesh->triangles()[result.worst_lipschitz_face];
  EXPECT_NE(std::ranges::find(corners, vertex), corners.end());
  EXPECT_NE(result.where.find("on face " + std::to_string(result.worst_lipschitz_face)), std::string::npos);
}

/// The way through one face is lost: distances and paths of the surface without that face, right in themselves; points
/// of the face have their neighbours' distances on its edges, else that over its nearest corner.
class WithoutFace : public ShortestPathMap {
 public:
  WithoutFace(const Exact& whole, Index face)
      : mesh_(*whole.mesh), common_(mesh_), face_(face), holed_(holed(whole, face)) {}

  std::span<const double> vertices() const override { return holed_.map->vertices(); }
  Distance at(const SurfacePoint& point) const override {
    const auto [start, detour] = entrance(point);
    Distance distance = holed_.map->at(start);
    return distance.value += detour, distance;
  }
  void path(const SurfacePoint& point, std::vector<SurfacePoint>& out) const override {
    const auto [start, detour] = entrance(point);
    holed_.map->path(start, out);
    if (detour > 0) out.insert(out.begin(), start);
    for (SurfacePoint& step : out)
      if (step.face >= face_) ++step.face;
    if (!out.empty()) out.front() = point;
  }
  std::span<const Counter> counters() const override { return holed_.map->counters(); }

 private:
  static Exact holed(const Exact& whole, Index face) {
    std::vector<Triangle> faces(whole.mesh->triangles().begin(), whole.mesh->triangles().end());
    faces.erase(faces.begin() + face);
    std::vector<Source> sources = whole.sources;
    for (Source& source : sources) source.at = renumbered(source.at, face);
    return {make({whole.mesh->positions().begin(), whole.mesh->positions().end()}, std::move(faces)), sources};
  }

  static SurfacePoint renumbered(SurfacePoint point, Index without) {
    if (point.face > without) --point.face;
    return point;
  }

  /// Where a point's path begins on the holed surface, and how far that is.
  std::pair<SurfacePoint, double> entrance(const SurfacePoint& point) const {
    const SurfacePoint kept = point.face == face_ ? common_.on_next_face(point) : point;
    if (kept.face != face_) return {renumbered(kept, face_), 0};
    std::pair<SurfacePoint, double> best;
    double shortest = infinity;
    for (const Index corner : mesh_.triangles()[face_]) {
      const double detour = distance(mesh_.position(point), mesh_.positions()[corner]);
      if (const double over = holed_.map->vertices()[corner] + detour; over < shortest)
        shortest = over, best = {holed_.mesh->at_vertex(corner), detour};
    }
    return best;
  }

  const SurfaceMesh& mesh_;
  CommonFace common_;
  Index face_;
  Exact holed_;
};

/// The face that most paths cross from edge to edge, among those that hold no source.
Index crossed_face(const Exact& exact) {
  const CommonFace common(*exact.mesh);
  std::vector<int> crossings(exact.mesh->face_count());
  std::vector<SurfacePoint> path;
  for (Index from = 0; from < exact.mesh->face_count(); ++from) {
    exact.map->path({from, {0.25, 0.35, 0.4}}, path);
    for (std::size_t i = 1; i + 2 < path.size(); ++i)
      for (Index f = 0; f < exact.mesh->face_count(); ++f)
        crossings[f] += common.on_face(path[i], f) && common.on_face(path[i + 1], f);
  }
  for (Index f = 0; f < exact.mesh->face_count(); ++f)
    for (const Source& source : exact.sources)
      if (common.on_face(source.at, f)) crossings[f] = 0;
  return static_cast<Index>(std::ranges::max_element(crossings) - crossings.begin());
}

TEST_P(AuditTest, CatchesAWindowThatWasLostOnItsWayThroughAFace) {
  const WithoutFace lost(exact(), crossed_face(exact()));
  const AuditResult result = exact().audit(lost, everything);
  EXPECT_GT(result.worst_lipschitz, caught);
}

TEST_P(AuditTest, CatchesADistanceThatDependsOnTheFaceItIsAskedOn) {
  const Index face = reached_face(exact());
  const AuditResult result = exact().audit_changed(no_paths, [&](const SurfacePoint& point, Distance right) {
    return point.face == face ? times(1 + 1e-6, right) : right;
  });
  EXPECT_GT(result.worst_lipschitz, caught);
}

TEST_P(AuditTest, CatchesAListOfVerticesThatSaysSomethingElse) {
  for (const Index v : some_vertices(exact())) {
    std::vector<double> list(exact().map->vertices().begin(), exact().map->vertices().end());
    list[v] += 1e-6;
    EXPECT_GT(exact().audit(FalsifiedMap(*exact().map, list), no_paths).worst_lipschitz, caught) << "vertex " << v;
  }
}

TEST(Audit, AllowsAnyDistancesWithinTheFactor) {
  const Exact exact = on_torus();
  std::mt19937_64 random(5);
  const FalsifiedMap within(
      *exact.map, [&](const SurfacePoint&, Distance distance) { return times(1 + 0.1 * uniform(random), distance); });
  EXPECT_LT(exact.audit(within, no_paths, 1.1).worst_lipschitz, rounding);
}

TEST(Audit, CatchesDistancesBeyondTheFactor) {
  const Exact exact = on_torus();
  const FalsifiedMap beyond(*exact.map, [](const SurfacePoint&, Distance right) { return times(1.12, right); });
  EXPECT_GT(exact.audit(beyond, no_paths, 1.1).worst_lipschitz, caught);
}

TEST(Audit, LooksAtPathsAloneWithoutAFactor) {
  const Exact exact = on_torus();
  const FalsifiedMap far_off(*exact.map, [](const SurfacePoint&, Distance right) { return times(3, right); });
  const AuditResult result = exact.audit(far_off, paths_of_any_length, infinity);
  EXPECT_EQ(result.pairs, 0u);
  EXPECT_GT(result.paths, 0u);
  EXPECT_EQ(result.worst_lipschitz, 0);
}

TEST(Audit, CatchesASourceThatIsNotAtItsStart) {
  const Exact exact = on_torus();
  const FalsifiedMap later(*exact.map, [](const SurfacePoint&, Distance right) { return right.value += 1e-6, right; });
  EXPECT_GT(exact.audit(later, no_paths).worst_lipschitz, caught);
}

TEST(Audit, CatchesADistanceInAComponentWithoutASource) {
  const Exact exact = on_two_components();
  const FalsifiedMap reached(*exact.map, [](const SurfacePoint&, Distance right) {
    return right.reach == Reach::reached ? right : Distance{100, Reach::reached, 0};
  });
  EXPECT_EQ(exact.audit(reached, everything).worst_lipschitz, infinity);
}

TEST(Audit, TakesTheShareOfFacesItIsAskedFor) {
  const Exact exact = on_torus();
  const AuditResult result = audit(*exact.mesh, exact.sources, *exact.map, everything, {.share = 0.25, .seed = 3});
  EXPECT_EQ(result.faces, (exact.mesh->face_count() + 3) / 4);
}

TEST(Audit, RefusesASolverThatCannotBeAskedAtAnyPoint) {
  const Exact exact = on_torus();
  EXPECT_THROW(exact.audit(*exact.map, Provides::paths), CapabilityError);
}

TEST(Audit, RefusesAShareOfNothing) {
  const Exact exact = on_torus();
  EXPECT_THROW(audit(*exact.mesh, exact.sources, *exact.map, everything, {.share = 0}), OptionError);
}

}  // namespace
}  // namespace geodrome
