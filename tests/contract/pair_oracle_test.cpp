// SPDX-License-Identifier: MIT
// Every solver that provides pair_queries: the answers of its oracle, and the oracle that was saved and read.
#include <algorithm>
#include <sstream>
#include <thread>

#include "contract/solver_contract.hpp"
#include "support/recording_context.hpp"

namespace geodrome::test {
namespace {

using Points = std::vector<SurfacePoint>;

/// An oracle with all that it lives on.
struct Oracle {
  std::unique_ptr<PreparedSurface> prepared;
  std::unique_ptr<PairOracle> oracle;

  /// Built, or read from `payload`.
  Oracle(const SolverPlugin& plugin, const MeshPtr& mesh, RunContext& context, const std::string* payload = nullptr)
      : prepared(plugin.object->prepare(mesh, context)) {
    if (!payload) {
      oracle = prepared->pair_oracle(nullptr, context);
      return;
    }
    std::istringstream stream(*payload);
    oracle = prepared->pair_oracle(&stream, context);
  }

  double operator()(const SurfacePoint& from, const SurfacePoint& to) const { return oracle->distance(from, to); }
  std::string saved() const {
    std::ostringstream out;
    oracle->save(out);
    return out.str();
  }
  /// All pairs of the points, row by row.
  std::vector<double> table(const Points& points) const {
    std::vector<double> values;
    for (const SurfacePoint& from : points)
      for (const SurfacePoint& to : points) values.push_back(oracle->distance(from, to));
    return values;
  }
};

class PairOracles : public SolverContract {
 protected:
  Oracle built(const MeshPtr& mesh) {
    Oracle oracle(plugin(), mesh, quiet_);
    EXPECT_TRUE(oracle.oracle) << "promised with pair_queries";
    return oracle;
  }

  static Points some_vertices(const SurfaceMesh& mesh, int count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Points points;
    while (points.size() < static_cast<std::size_t>(count)) {
      const Triangle& t = mesh.triangles()[random() % mesh.face_count()];
      points.push_back(mesh.at_vertex(t[random() % 3]));
    }
    return points;
  }
  static Points some_points(const SurfaceMesh& mesh, int count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Points points;
    for (int i = 0; i < count; ++i) points.push_back(random_point(mesh, random));
    return points;
  }

  /// All pairs of the points against the reference: nowhere shorter, and within the factor if that is promised of them.
  void expect_within_factor(const MeshPtr& mesh, const Points& points, bool promised) {
    if (!reference() || reference()->name == plugin().name) GTEST_SKIP() << "nothing to compare with";
    const Oracle oracle = built(mesh);
    Running truth(*reference(), mesh);
    for (const SurfacePoint& from : points) {
      const ShortestPathMap& map = truth.map({{from}});
      for (const SurfacePoint& to : points) {
        const double wanted = map.at(to).value, value = oracle(from, to);
        EXPECT_GE(value, wanted - rounding * scale_);
        if (promised && std::isfinite(plugin().factor)) {
          EXPECT_LE(value, plugin().factor * wanted + rounding * scale_);
        }
      }
    }
  }

  const MeshPtr mesh_ = terrain(9, 1.5, 31);
  const double scale_ = 15;  ///< about the largest distance
  QuietContext quiet_;
};

TEST_P(PairOracles, AreWithinTheFactorBetweenVertices) {
  GEODROME_NEEDS(pair_queries);
  expect_within_factor(mesh_, some_vertices(*mesh_, 25, 1), true);
}

TEST_P(PairOracles, AreWithinTheFactorBetweenAnyPointsIfThatIsPromised) {
  GEODROME_NEEDS(pair_queries);
  expect_within_factor(mesh_, some_points(*mesh_, 20, 2), has(factor_any_point));
}

TEST_P(PairOracles, AreWithinTheFactorOnABumpyTorus) {
  GEODROME_NEEDS(pair_queries);
  const MeshPtr mesh = bumpy_torus(18, 9, 0.08, 5);
  expect_within_factor(mesh, some_points(*mesh, 15, 3), has(factor_any_point));
}

/// Pairs that a region of the surface holds both ends of, often answered in another way than others.
TEST_P(PairOracles, AreWithinTheFactorBetweenPointsOfOneFaceAndOfNeighbours) {
  GEODROME_NEEDS(pair_queries);
  Points points;
  for (const Index face : {40u, 41u, 42u, 43u})
    for (const double b : {0.02, 0.3, 0.9}) points.push_back({face, {b, 0.4 * (1 - b), 1 - b - 0.4 * (1 - b)}});
  expect_within_factor(mesh_, points, has(factor_any_point));
}

TEST_P(PairOracles, AreSymmetricWithinTheFactor) {
  GEODROME_NEEDS(pair_queries);
  const Oracle oracle = built(mesh_);
  const double factor = std::isfinite(plugin().factor) ? plugin().factor : 1;
  const Points points = has(factor_any_point) ? some_points(*mesh_, 20, 4) : some_vertices(*mesh_, 20, 4);
  for (const SurfacePoint& a : points)
    for (const SurfacePoint& b : points) EXPECT_LE(oracle(a, b), factor * oracle(b, a) + rounding * scale_);
}

TEST_P(PairOracles, GiveZeroFromAPointToItself) {
  GEODROME_NEEDS(pair_queries);
  const Oracle oracle = built(mesh_);
  for (const SurfacePoint& point : some_points(*mesh_, 40, 5)) EXPECT_NEAR(oracle(point, point), 0, rounding * scale_);
}

/// A vertex has a name in each of its faces.
TEST_P(PairOracles, DoNotMindWhichFaceNamesAVertex) {
  GEODROME_NEEDS(pair_queries);
  const Oracle oracle = built(mesh_);
  const SurfacePoint from = mesh_->at_vertex(3);
  for (Index face = 0; face < mesh_->face_count(); face += 7)
    for (int corner = 0; corner < 3; ++corner) {
      SurfacePoint here{face, {}};
      here.b[corner] = 1;
      const SurfacePoint usual = mesh_->at_vertex(mesh_->triangles()[face][corner]);
      EXPECT_NEAR(oracle(here, usual), 0, rounding * scale_);
      EXPECT_NEAR(oracle(from, here), oracle(from, usual), rounding * scale_);
    }
}

TEST_P(PairOracles, GiveInfinityBetweenComponentsAlone) {
  GEODROME_NEEDS(pair_queries);
  const MeshPtr mesh = both(octahedron(), mapped(octahedron(), [](const Vec3& p) { return p + Vec3{5, 0, 0}; }));
  GEODROME_FITS(mesh);
  const Oracle oracle = built(mesh);
  for (Index from = 0; from < 16; ++from)
    for (Index to = 0; to < 16; ++to)
      for (const auto& b : {std::array<double, 3>{1, 0, 0}, {0, 0.25, 0.75}, {0.5, 0.25, 0.25}})
        EXPECT_EQ(std::isfinite(oracle({from, {0.25, 0.25, 0.5}}, {to, b})), (from < 8) == (to < 8));
}

TEST_P(PairOracles, RefuseAPointOffTheMesh) {
  GEODROME_NEEDS(pair_queries);
  const Oracle oracle = built(mesh_);
  const SurfacePoint good = mesh_->at_vertex(0), bad{static_cast<Index>(mesh_->face_count()), {1, 0, 0}};
  EXPECT_THROW(oracle(good, bad), InputError);
  EXPECT_THROW(oracle(bad, good), InputError);
}

TEST_P(PairOracles, AnswerWithTheSameBytesWhenSavedAndRead) {
  GEODROME_NEEDS(pair_queries);
  const Oracle first = built(mesh_);
  const std::string payload = first.saved();
  const Oracle second(plugin(), mesh_, quiet_, &payload);
  ASSERT_TRUE(second.oracle);
  const Points points = some_points(*mesh_, 20, 6);
  EXPECT_TRUE(same_bytes(first.table(points), second.table(points)));
  EXPECT_TRUE(second.saved() == payload);
}

TEST_P(PairOracles, ThrowOnATruncatedPayload) {
  GEODROME_NEEDS(pair_queries);
  const std::string payload = built(mesh_).saved();
  ASSERT_FALSE(payload.empty());
  for (std::size_t k = 0; k < 40; ++k) {
    const std::string part =
        payload.substr(0, k < 20 ? std::min(k, payload.size() - 1) : payload.size() * (k - 20) / 20);
    EXPECT_THROW(Oracle(plugin(), mesh_, quiet_, &part), InputError) << part.size() << " of " << payload.size();
  }
  const std::string all_but_one = payload.substr(0, payload.size() - 1);
  EXPECT_THROW(Oracle(plugin(), mesh_, quiet_, &all_but_one), InputError);
}

TEST_P(PairOracles, ThrowOnAForeignPayload) {
  GEODROME_NEEDS(pair_queries);
  const std::string other = built(terrain(5, 1, 9)).saved();
  EXPECT_THROW(Oracle(plugin(), mesh_, quiet_, &other), InputError) << "of another mesh";
  std::mt19937_64 random(7);
  for (int k = 0; k < 50; ++k) {
    std::string noise(1 + random() % 3000, '\0');
    for (char& c : noise) c = static_cast<char>(random());
    EXPECT_THROW(Oracle(plugin(), mesh_, quiet_, &noise), InputError);
  }
  for (const char byte : {'\0', '\xff'}) {
    const std::string same(2000, byte);
    EXPECT_THROW(Oracle(plugin(), mesh_, quiet_, &same), InputError);
  }
}

/// The engine's checksum finds such bytes before; a plugin that is asked otherwise may be deceived but must not crash.
TEST_P(PairOracles, SurviveReadingAPayloadWithAWrongByte) {
  GEODROME_NEEDS(pair_queries);
  const std::string payload = built(mesh_).saved();
  std::mt19937_64 random(8);
  for (int k = 0; k < 100; ++k) {
    std::string wrong = payload;
    wrong[k < 50 ? std::min<std::size_t>(k, payload.size() - 1) : random() % payload.size()] ^= '\x81';
    try {
      Oracle(plugin(), mesh_, quiet_, &wrong);
    } catch (const InputError&) {
    }
  }
}

TEST_P(PairOracles, AnswerAlikeHoweverManyThreadsBuiltThem) {
  GEODROME_NEEDS(pair_queries);
  RecordingContext two;
  const Points points = some_points(*mesh_, 15, 9);
  EXPECT_TRUE(same_bytes(built(mesh_).table(points), Oracle(plugin(), mesh_, two).table(points)));
}

TEST_P(PairOracles, AnswerTwoThreadsAtOnceAlike) {
  GEODROME_NEEDS(pair_queries);
  const Oracle oracle = built(mesh_);
  const Points points = some_points(*mesh_, 30, 10);
  std::vector<double> a, b;
  std::thread one([&] { a = oracle.table(points); }), two([&] { b = oracle.table(points); });
  one.join(), two.join();
  EXPECT_TRUE(same_bytes(a, b));
  EXPECT_TRUE(same_bytes(a, oracle.table(points)));
}

TEST_P(PairOracles, StopBeingBuiltWhenCancelled) {
  GEODROME_NEEDS(pair_queries);
  const auto prepared = plugin().object->prepare(mesh_, quiet_);
  CancelAfter at_once(0);
  EXPECT_THROW(prepared->pair_oracle(nullptr, at_once), Cancelled);
  EXPECT_TRUE(prepared->pair_oracle(nullptr, quiet_)) << "and can be built afterwards";
}

TEST_P(PairOracles, AreNoneWhereNotProvided) {
  if (has(pair_queries)) GTEST_SKIP() << plugin().name << " provides them";
  GEODROME_FITS(mesh_);
  EXPECT_FALSE(plugin().object->prepare(mesh_, quiet_)->pair_oracle(nullptr, quiet_));
}

/// The tests' own oracle beside those of the build, so that the suite is never empty.
std::vector<SolverPlugin> all_solvers() {
  std::vector<SolverPlugin> plugins = discovered<ShortestPathSolver>();
  plugins.push_back(*discovered_in<ShortestPathSolver>(GEODROME_BINARY_DIR "/tests/bad_plugins/solver_test_pairs.so"));
  return plugins;
}

INSTANTIATE_TEST_SUITE_P(Every, PairOracles, testing::ValuesIn(all_solvers()), plugin_name);

}  // namespace
}  // namespace geodrome::test
