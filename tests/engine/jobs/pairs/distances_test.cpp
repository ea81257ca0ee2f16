// SPDX-License-Identifier: MIT
// Asking an oracle for pairs, over threads, and the checks of its answers.
#include "engine/jobs/pairs/distances.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "tests/support/meshes.hpp"

namespace geodrome::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Answers as it is told; straight through space by default.
class ToldOracle final : public PairOracle {
 public:
  using Answer = double (*)(double straight);
  explicit ToldOracle(
      MeshPtr mesh, Answer answer = [](double straight) { return straight; })
      : mesh_(std::move(mesh)), answer_(answer) {}
  double distance(const SurfacePoint& from, const SurfacePoint& to) const override {
    return answer_(geodrome::distance(mesh_->position(from), mesh_->position(to)));
  }
  void save(std::ostream&) const override {}

 private:
  MeshPtr mesh_;
  Answer answer_;
};

class CancelledContext final : public QuietContext {
 public:
  bool cancelled() const noexcept override { return true; }
};

class PairQueries : public testing::Test {
 protected:
  PairQueries() {
    surface_.mesh = mesh_;
    solver_.plugin.info.stage = "solver", solver_.plugin.info.name = "told";
    solver_.plugin.info.provides = Provides::never_shorter;
    solver_.plugin.factor = infinity;  // it has no searches that an audit could ask
  }
  NamedPoint vertex(Index v) const {
    return {{Place::State::on_surface, mesh_->at_vertex(v), v, mesh_->positions()[v]}, 0, v, std::to_string(v)};
  }
  std::vector<NamedPair> many(std::size_t count) const {
    std::mt19937_64 random(3);
    std::vector<NamedPair> pairs;
    const auto draw = [&] { return vertex(static_cast<Index>(random() % mesh_->vertex_count())); };
    for (std::size_t i = 0; i < count; ++i) pairs.push_back({draw(), draw()});
    return pairs;
  }
  PairDistances ask(const std::vector<NamedPair>& pairs, ToldOracle::Answer answer, unsigned threads = 1) {
    return pair_distances(surface_, solver_, ToldOracle(mesh_, answer), pairs, threads, context_);
  }
  PairDistances ask(const std::vector<NamedPair>& pairs, unsigned threads = 1) {
    return ask(
        pairs, [](double straight) { return straight; }, threads);
  }

  const MeshPtr mesh_ = plane_grid(6);
  PlacedSurface surface_;
  PreparedSolver solver_;
  QuietContext context_;
};

TEST_F(PairQueries, GiveTheSameBytesForAnyNumberOfThreads) {
  const auto pairs = many(3000);
  const PairDistances one = ask(pairs, 1), four = ask(pairs, 4);
  ASSERT_EQ(one.values.size(), 3000u);
  EXPECT_EQ(0, std::memcmp(one.values.data(), four.values.data(), 3000 * sizeof(double)));
  EXPECT_EQ(one.threads, 1u);
  EXPECT_EQ(four.threads, 4u);
  EXPECT_TRUE(one.sound());
  EXPECT_EQ(one.asked, 3000u);
}

TEST_F(PairQueries, GiveNanToDroppedAndInfinityToIsolatedEndsWithoutAsking) {
  NamedPoint dropped, isolated;
  isolated.place.state = Place::State::isolated, isolated.place.vertex = 1;
  const std::vector<NamedPair> pairs{
      {dropped, vertex(0)}, {vertex(0), dropped}, {vertex(1), isolated}, {isolated, isolated}, {vertex(0), vertex(1)}};
  // Vertex 1 is on faces of this mesh; here it only stands for one that is not.
  const PairDistances result = ask(pairs);
  EXPECT_TRUE(std::isnan(result.values[0]));
  EXPECT_TRUE(std::isnan(result.values[1]));
  EXPECT_EQ(result.values[2], infinity);
  EXPECT_EQ(result.values[3], 0);
  EXPECT_EQ(result.asked, 1u);
  EXPECT_EQ(result.reach.not_computed, 2u);
}

TEST_F(PairQueries, CountWhatIsShorterThanTheStraightLine) {
  const std::vector<NamedPair> pairs{{vertex(0), vertex(8)}, {vertex(0), vertex(0)}};
  EXPECT_EQ(ask(pairs, [](double straight) { return straight * (1 - 1e-12); }).below_euclid, 0u) << "rounding";
  EXPECT_EQ(ask(pairs, [](double straight) { return straight * (1 - 1e-6); }).below_euclid, 1u);
  solver_.plugin.info.provides = Provides::nothing;
  EXPECT_EQ(ask(pairs, [](double straight) { return straight * (1 - 1e-6); }).below_euclid, 0u) << "not promised";
}

TEST_F(PairQueries, OnFaceWeightsAreNotComparedWithTheStraightLine) {
  const std::vector<Vec3> positions(mesh_->positions().begin(), mesh_->positions().end());
  const std::vector<Triangle> triangles(mesh_->triangles().begin(), mesh_->triangles().end());
  surface_.mesh = std::make_shared<const SurfaceMesh>(positions, triangles, std::vector<double>(triangles.size(), 0.5));
  EXPECT_TRUE(ask({{vertex(0), vertex(8)}}, [](double straight) { return straight / 2; }).sound());
}

TEST_F(PairQueries, CountPointsThatAreAwayFromThemselves) {
  const PairDistances result =
      ask({{vertex(2), vertex(2)}, {vertex(2), vertex(3)}}, [](double straight) { return straight + 0.1; });
  EXPECT_EQ(result.not_zero, 1u);
  EXPECT_FALSE(result.sound());
}

TEST_F(PairQueries, CountInfinityWithinAndNumbersBetweenComponents) {
  const MeshPtr two = both(mesh_, mapped(mesh_, [](const Vec3& p) { return p + Vec3{0, 0, 9}; }));
  surface_.mesh = two;
  NamedPoint there = vertex(0);
  there.place.vertex = static_cast<Index>(mesh_->vertex_count()), there.place.at = two->at_vertex(there.place.vertex);
  const std::vector<NamedPair> pairs{{vertex(0), vertex(5)}, {vertex(0), there}};
  const auto asked = [&](ToldOracle::Answer answer) {
    return pair_distances(surface_, solver_, ToldOracle(two, answer), pairs, 1, context_).reach;
  };
  EXPECT_EQ(asked([](double) { return infinity; }).missed, 1u);
  EXPECT_EQ(asked([](double) { return infinity; }).unreachable, 1u);
  EXPECT_EQ(asked([](double straight) { return straight; }).impossible, 1u);
}

TEST_F(PairQueries, OfACloudAreNotShorterThanTheStraightLineOfThePoints) {
  surface_.made_from = InputKind::points;
  NamedPair pair{vertex(0), vertex(1)};
  pair.from.place.position = {0, 0, 3};
  const PairDistances result = ask({pair});
  EXPECT_EQ(result.values[0], std::sqrt(10.0));
  EXPECT_TRUE(result.sound());
}

TEST_F(PairQueries, NameThePairAndThePluginOfWhatIsNoDistance) {
  for (const ToldOracle::Answer answer : {+[](double) { return nan; }, +[](double) { return -1.0; }}) try {
      ask({{vertex(3), vertex(4)}}, answer);
      ADD_FAILURE() << "was accepted";
    } catch (const NumericalError& error) {
      EXPECT_NE(std::string(error.what()).find("pair 0 (3, 4)"), std::string::npos) << error.what();
      EXPECT_EQ(error.plugin(), "solver_told");
    }
}

TEST_F(PairQueries, TellInFullWhatIsBelowZeroByLittle) {
  try {
    ask({{vertex(3), vertex(4)}}, [](double) { return -1e-9; });
    ADD_FAILURE() << "was accepted";
  } catch (const NumericalError& error) {
    EXPECT_NE(std::string(error.what()).find("computed -1e-09 as"), std::string::npos) << error.what();
  }
}

TEST_F(PairQueries, CanBeCancelled) {
  CancelledContext cancelled;
  EXPECT_THROW(pair_distances(surface_, solver_, ToldOracle(mesh_), many(10), 2, cancelled), Cancelled);
}

}  // namespace
}  // namespace geodrome::test
