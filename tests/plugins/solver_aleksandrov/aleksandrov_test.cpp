// SPDX-License-Identifier: MIT
#include <limits>
#include <numbers>

#include "engine/surface/common_face.hpp"
#include "tests/plugins/solvers/fixture.hpp"
#include "plugins/solver_aleksandrov/intrinsic/delaunay.hpp"
#include "plugins/solver_aleksandrov/steiner_points.hpp"
#include "tests/support/meshes.hpp"
#include "tools/shapes/fuzz_mesh.hpp"
#include "tools/shapes/hostile.hpp"

/// What the solver of Aleksandrov, Maheshwari and Sack promises: distances d <= D <= (1 + delta) d between any points,
/// whatever the placement and the triangulation, and paths that are as long as it says.
namespace geodrome::test {
namespace {

using shapes::Random;

/// Rounding, relative to the largest distance.
constexpr double rounding_of_distances = 1e-12;
/// Rounding between points near each other, relative to the longest side of their faces: coordinates on a face are
/// within 1e-16 of themselves, so places are within a few times that of the longest side.
constexpr double rounding_of_places = 1e-14;

constexpr double deltas[] = {1, 0.5, 0.1};
/// Larger graphs are left out: a search takes a tenth of a second.
constexpr double most_edges = 1e7;

/// A solver at work on a mesh.
class Run {
 public:
  Run(const std::string& selection, const MeshPtr& mesh) : solver_(load_solver(selection)) {
    QuietContext context;
    prepared_ = solver_.object->prepare(mesh, context);
    search_ = prepared_->make_search();
  }
  const ShortestPathMap& from(const std::vector<Source>& sources) {
    QuietContext context;
    Request request;
    request.keep = Keep::map;
    return search_->run(sources, request, context);
  }

 private:
  Plugin<ShortestPathSolver> solver_;
  std::unique_ptr<PreparedSurface> prepared_;
  std::unique_ptr<Search> search_;
};

/// A placement, a triangulation.
using Way = std::tuple<std::string, std::string>;

std::string selection(const Way& way, double delta) {
  return "aleksandrov:delta=" + std::to_string(delta) + ",placement=" + std::get<0>(way) +
         ",triangulation=" + std::get<1>(way);
}

/// About how many edges of its graph a search compares: what a test costs.
double edges(const MeshPtr& mesh, const Way& way, double delta) {
  using namespace aleksandrov;
  const auto& [placement, triangulation] = way;
  const QuietContext context;
  const PackedMesh surface(mesh);
  IntrinsicTriangulation t(surface, 1e-14);
  const auto counted = [&] {
    return edge_count(t, {t, placement == "thin" ? Placement::thin : Placement::published, delta, 1});
  };
  if (triangulation == "as_is") return counted();
  make_delaunay(t, context);
  const double flipped = counted();
  if (triangulation == "flipped") return flipped;
  refine(t, std::numbers::pi / 9, 100000, context);
  return std::min(flipped, counted());
}

class AleksandrovFactor : public testing::TestWithParam<Way> {};

/// 10^-1 ... 10^-12, or nothing at all.
double tiny(Random& random) { return random.index(8) == 0 ? 0 : std::pow(10, -random.uniform(1, 12)); }

SurfacePoint point_in(Index face, Random& random) {
  const double a = random.uniform(), b = random.uniform();
  const double p = std::min(a, b), q = std::max(a, b);
  return {face, {p, q - p, 1 - q}};
}

/// Near corner i of a face.
SurfacePoint near_corner(Index face, int i, Random& random) {
  SurfacePoint p{face, {}};
  const double away = tiny(random), share = random.index(4) ? random.uniform() : 0;
  p.b[(i + 1) % 3] = away * share, p.b[(i + 2) % 3] = away * (1 - share);
  p.b[i] = 1 - p.b[(i + 1) % 3] - p.b[(i + 2) % 3];
  return p;
}

/// Near the edge from corner i of a face, at `share` of it.
SurfacePoint near_edge(Index face, int i, double share, Random& random) {
  SurfacePoint p{face, {}};
  p.b[(i + 2) % 3] = tiny(random);
  p.b[(i + 1) % 3] = share * (1 - p.b[(i + 2) % 3]);
  p.b[i] = 1 - p.b[(i + 1) % 3] - p.b[(i + 2) % 3];
  return p;
}

/// Points near one another: around a vertex, an edge or a point inside a face.
std::vector<SurfacePoint> crowd(const MeshPtr& mesh, Random& random) {
  const Index face = static_cast<Index>(random.index(mesh->face_count()));
  const int i = static_cast<int>(random.index(3)), j = (i + 1) % 3;
  const Triangle& t = mesh->triangles()[face];
  const double share = random.uniform();
  const auto kind = random.index(3);
  std::vector<SurfacePoint> points;
  for (Index f = 0; f < mesh->face_count(); ++f) {
    const Triangle& other = mesh->triangles()[f];
    for (int k = 0; k < 3; ++k) {
      const Index a = other[k], b = other[(k + 1) % 3];
      if (kind == 0 && a == t[i]) points.push_back(near_corner(f, k, random));
      if (kind == 1 && a == t[i] && b == t[j]) points.push_back(near_edge(f, k, share, random));
      if (kind == 1 && b == t[i] && a == t[j]) points.push_back(near_edge(f, k, 1 - share, random));
    }
  }
  if (kind == 2) points.push_back(point_in(face, random));
  for (int n = 0; n < 4; ++n) {
    SurfacePoint p = points[random.index(points.size())];
    const double part = tiny(random);
    const SurfacePoint q = point_in(p.face, random);
    for (int k = 0; k < 3; ++k) p.b[k] += part * (q.b[k] - p.b[k]);
    points.push_back(p);
  }
  return points;
}

double longest_side(const MeshPtr& mesh, Index face) {
  const auto [p, q, r] = mesh->corners(face);
  return std::max({distance(p, q), distance(q, r), distance(r, p)});
}

/// Points to ask for, and sources to ask from.
struct Questions {
  std::vector<Source> sources;
  std::vector<SurfacePoint> anywhere, near;  ///< `near`: the sources, and beside each other

  explicit Questions(const SurfacePoint& source) : sources{{source, 0}} {}
  Questions(const MeshPtr& mesh, std::size_t source_count, Random& random) {
    for (int n = 0; n < 30; ++n)
      anywhere.push_back(point_in(static_cast<Index>(random.index(mesh->face_count())), random));
    for (int n = 0; n < 3; ++n)
      for (const SurfacePoint& p : crowd(mesh, random)) anywhere.push_back(p);
    near = crowd(mesh, random);
    sources.push_back({near[random.index(near.size())], 0});
    while (sources.size() < source_count)
      sources.push_back({anywhere[random.index(anywhere.size())], random.uniform(0, longest_side(mesh, 0))});
  }
};

/// A place in a face with the tip of a fan as corner 0, at `scale` times the distance from the tip.
SurfacePoint nearer(const SurfacePoint& p, double scale) {
  return {p.face, {1 - scale * (p.b[1] + p.b[2]), scale * p.b[1], scale * p.b[2]}};
}

/// That D is a distance within the factor, given the true one; `noise` is an absolute error of both.
void expect_within(double d, double D, double delta, double noise) {
  if (d == std::numeric_limits<double>::infinity()) {
    EXPECT_EQ(D, d);
    return;
  }
  EXPECT_GE(D, d - noise) << "shorter by " << d - D;
  EXPECT_LE(D, (1 + delta) * d + noise) << "d " << d << ", delta " << delta << ", D / d - 1 = " << D / d - 1;
}

/// The largest finite distance of a vertex.
double largest(const ShortestPathMap& map) {
  double most = 0;
  for (const double d : map.vertices())
    if (std::isfinite(d)) most = std::max(most, d);
  return most;
}

void expect_factor(const MeshPtr& mesh, const Questions& ask, const ShortestPathMap& exact, const ShortestPathMap& map,
                   double delta) {
  const double noise = rounding_of_distances * largest(exact);
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    SCOPED_TRACE("vertex " + std::to_string(v));
    expect_within(exact.vertices()[v], map.vertices()[v], delta, noise);
  }
  for (const SurfacePoint& p : ask.anywhere) {
    SCOPED_TRACE(testing::Message() << "face " << p.face << " b " << p.b[0] << " " << p.b[1] << " " << p.b[2]);
    expect_within(exact.at(p).value, map.at(p).value, delta, noise);
  }
  for (const SurfacePoint& p : ask.near) {
    SCOPED_TRACE(testing::Message() << "near: face " << p.face << " b " << p.b[0] << " " << p.b[1] << " " << p.b[2]);
    const double size = std::max(longest_side(mesh, p.face), longest_side(mesh, ask.sources[0].at.face));
    const double start_noise = ask.sources.size() > 1 ? noise : 0;
    expect_within(exact.at(p).value, map.at(p).value, delta, rounding_of_places * size + start_noise);
  }
}

/// That a path is as long as the distance says, on the surface; rounding is relative to `size`.
void expect_path(const MeshPtr& mesh, const CommonFace& faces, const ShortestPathMap& map, const Questions& ask,
                 const SurfacePoint& to, double size) {
  const Distance distance = map.at(to);
  if (distance.reach != Reach::reached) return;
  std::vector<SurfacePoint> path;
  map.path(to, path);
  ASSERT_FALSE(path.empty());
  EXPECT_EQ(path.front(), to);
  EXPECT_EQ(mesh->position(path.back()), mesh->position(ask.sources[distance.source].at));
  double length = ask.sources[distance.source].start;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const auto piece = faces.straight(path[i], path[i + 1]);
    ASSERT_TRUE(piece) << "piece " << i << " of " << path.size() << " is in no face";
    length += *piece;
  }
  EXPECT_NEAR(length, distance.value, rounding_of_distances * std::max(size, distance.value));
}

void expect_paths(const MeshPtr& mesh, const ShortestPathMap& map, const Questions& ask, Random& random) {
  const CommonFace faces(*mesh);
  for (const auto* points : {&ask.anywhere, &ask.near})
    for (const SurfacePoint& p : *points) {
      SCOPED_TRACE(testing::Message() << "path from face " << p.face << " b " << p.b[0] << " " << p.b[1] << " "
                                      << p.b[2]);
      expect_path(mesh, faces, map, ask, p, largest(map));
    }
  for (int n = 0; n < 20; ++n) {
    const Index v = random_vertex(mesh, random);
    if (mesh->first_half_edge(v) == no_index) continue;
    SCOPED_TRACE("path from vertex " + std::to_string(v));
    expect_path(mesh, faces, map, ask, mesh->at_vertex(v), largest(map));
  }
}

/// Both on a mesh: factor and paths, from one source and from several. False if that would take too long.
bool expect_promises(const MeshPtr& mesh, const Way& way, double delta, std::uint64_t seed) {
  if (edges(mesh, way, delta) > most_edges) return false;
  Random random(seed);
  Run exact("chen_han", mesh), run(selection(way, delta), mesh);
  for (const std::size_t sources : {1, 3}) {
    const Questions ask(mesh, sources, random);
    const SurfacePoint& at = ask.sources[0].at;
    SCOPED_TRACE(testing::Message() << "delta " << delta << ", " << sources << " sources, the first in face " << at.face
                                    << " b " << at.b[0] << " " << at.b[1] << " " << at.b[2]);
    const ShortestPathMap& map = run.from(ask.sources);
    expect_factor(mesh, ask, exact.from(ask.sources), map, delta);
    expect_paths(mesh, map, ask, random);
  }
  return true;
}

TEST_P(AleksandrovFactor, HoldsOnRandomMeshes) {
  const std::vector<MeshPtr> meshes = random_meshes(41);
  int judged = 0;
  for (std::size_t i = 0; i < meshes.size(); ++i)
    for (const double delta : deltas) {
      SCOPED_TRACE("random mesh " + std::to_string(i));
      judged += expect_promises(meshes[i], GetParam(), delta, 100 + i);
    }
  EXPECT_GE(judged, 14) << "too few are small enough";
}

TEST_P(AleksandrovFactor, HoldsWhereMoreThanTwoFacesMeet) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    for (const double delta : deltas) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      EXPECT_TRUE(expect_promises(finned(terrain(6, 0.7, seed), 3), GetParam(), delta, seed));
      EXPECT_TRUE(expect_promises(finned(bumpy_torus(6, 5, 0.1, seed), 4), GetParam(), delta, seed));
    }
}

TEST_P(AleksandrovFactor, HoldsOnUnorientedMeshes) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const double delta : deltas) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      EXPECT_TRUE(expect_promises(shaken(moebius(4 + static_cast<Index>(seed)), 0.1, seed), GetParam(), delta, seed));
    }
}

/// Some of them have faces without area.
TEST_P(AleksandrovFactor, HoldsOnFuzzMeshes) {
  int judged = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const shapes::FuzzMesh fuzz = shapes::fuzz_mesh(seed);
    if (fuzz.mesh.face_count() > 1000) continue;
    SCOPED_TRACE("fuzz:" + std::to_string(seed) + " (" + fuzz.recipe + ")");
    judged += expect_promises(share(fuzz.mesh), GetParam(), deltas[seed % 3], seed);
  }
  EXPECT_GE(judged, 6) << "too few are small enough";
}

TEST_P(AleksandrovFactor, HoldsOnHostileMeshes) {
  int judged = 0;
  for (const shapes::HostileFamily& family : shapes::hostile_families()) {
    SCOPED_TRACE("hostile:" + family.name);
    judged += expect_promises(share(family.make(0, 1)), GetParam(), 1, 1);
  }
  EXPECT_GE(judged, 9) << "too few are small enough";
}

/// Three vertices in line: all places of a face are within rounding of all its sides.
TEST_P(AleksandrovFactor, HoldsOnFacesWithoutArea) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_promises(share(shapes::collapsed_faces(10, seed)), GetParam(), 1, seed);
    const bool done = expect_promises(share(shapes::collapsed_faces(13, seed)), GetParam(), 1, seed);
    EXPECT_TRUE(done || std::get<1>(GetParam()) == "as_is");
  }
}

/// Paths cross several of them at one place.
TEST_P(AleksandrovFactor, HoldsOnFacesWithoutAreaInARow) {
  for (Index count = 1; count <= 10; ++count) {
    SCOPED_TRACE("vertices on the seam: " + std::to_string(count));
    const bool done = expect_promises(seam(count, count), GetParam(), 1, count);
    EXPECT_TRUE(done || std::get<1>(GetParam()) == "as_is") << "too many edges";
  }
}

/// A fan of flat faces with weights, around vertex 0: open, or closed and a cone or a saddle.
MeshPtr weighted_fan(Random& random) {
  const Index faces = 3 + static_cast<Index>(random.index(6));
  const MeshPtr plain = fan(faces, random.uniform(0.15, std::min(1.2, 5.5 / faces)));
  std::vector<double> weights;
  const std::size_t count = random.index(2) ? plain->face_count() : plain->face_count() - 1;
  for (std::size_t f = 0; f < count; ++f) weights.push_back(std::pow(10, random.uniform(-2, 0.5)));
  const auto faces_kept = plain->triangles().subspan(0, count);
  return share(SurfaceMesh({plain->positions().begin(), plain->positions().end()},
                           {faces_kept.begin(), faces_kept.end()}, weights));
}

/// Places so near the tip that no way to them leaves the fan, and places nearer in the same direction.
void expect_proportions(const MeshPtr& mesh, const ShortestPathMap& fine, const ShortestPathMap& map, double delta,
                        Random& random) {
  const auto [least, most] = std::ranges::minmax(mesh->face_weights());
  const Questions ask(mesh->at_vertex(0));
  const CommonFace faces(*mesh);
  for (int n = 0; n < 30; ++n) {
    const Index face = static_cast<Index>(random.index(mesh->face_count()));
    const SurfacePoint far = nearer(point_in(face, random), 0.2 * least / most);
    const double scale = std::pow(10, -random.uniform(0, 9)), d = scale * fine.at(far).value;
    const SurfacePoint near = nearer(far, scale);
    SCOPED_TRACE(testing::Message() << "delta " << delta << ", face " << face << ", scale " << scale);
    EXPECT_LE(map.at(near).value, (1 + delta) * d * (1 + rounding_of_distances));
    EXPECT_GE(1.05 * map.at(near).value, d * (1 - rounding_of_distances));
    expect_path(mesh, faces, map, ask, near, rounding_of_places / rounding_of_distances);
  }
}

TEST_P(AleksandrovFactor, HoldsOnWeightedFacesNearTheSource) {
  for (std::uint64_t seed = 1; seed <= 9; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const MeshPtr mesh = weighted_fan(random);
    const double delta = deltas[seed % 3];
    geodrome::test::Run fine(selection(GetParam(), 0.05), mesh), run(selection(GetParam(), delta), mesh);
    const std::vector<Source> tip{{mesh->at_vertex(0)}};
    expect_proportions(mesh, fine.from(tip), run.from(tip), delta, random);
  }
}

std::string way_name(const testing::TestParamInfo<Way>& info) {
  return std::get<0>(info.param) + "_" + std::get<1>(info.param);
}

INSTANTIATE_TEST_SUITE_P(Options, AleksandrovFactor,
                         testing::Combine(testing::Values("thin", "published"),
                                          testing::Values("as_is", "flipped", "refined")),
                         way_name);

TEST(AleksandrovThinning, HasNoFactor) {
  EXPECT_EQ(load_solver("aleksandrov:delta=0.1").factor, 1.1);
  EXPECT_EQ(load_solver("aleksandrov:delta=0.1,unguaranteed_thinning=2").factor,
            std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace geodrome::test
