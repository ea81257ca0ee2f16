// SPDX-License-Identifier: MIT
#include "plugins/common/exact/fan_envelope.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "plugins/common/exact/bisector.hpp"
#include "tools/shapes/random.hpp"

namespace geodrome::test {
namespace {

/// Five faces that share the edge from vertex 0 to vertex 1, of a length that is no power of two; some run along it,
/// some against it.
std::shared_ptr<const PackedMesh> fan_of_five() {
  std::vector<Vec3> positions{{0, 0, 0}, {0, 0, 1.3}};
  std::vector<Triangle> triangles;
  for (Index i = 0; i < 5; ++i) {
    positions.push_back({std::cos(i), std::sin(i), 0.5});
    triangles.push_back(i % 2 ? Triangle{0, 1, 2 + i} : Triangle{1, 0, 2 + i});
  }
  return std::make_shared<const PackedMesh>(
      std::make_shared<const SurfaceMesh>(std::move(positions), std::move(triangles)));
}

std::vector<Index> half_edges_of_the_fan(const PackedMesh& surface) {
  std::vector<Index> found;
  for (Index h = 0; h < 3 * surface.face_count(); ++h)
    if (surface.is_fan(h)) found.push_back(h);
  return found;
}

EdgePieces random_pieces(double length, shapes::Random& random) {
  std::vector<double> ends(2 * (1 + random.index(4)));
  for (double& end : ends) end = random.uniform(0, length);
  std::sort(ends.begin(), ends.end());
  EdgePieces pieces;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
    pieces.push_back({random.uniform(-1, 2), -random.uniform(), random.uniform(), ends[i], ends[i + 1],
                      static_cast<std::uint32_t>(pieces.size())});
  return pieces;
}

double distance_at(const EdgePieces& pieces, double place) {
  double least = infinity;
  for (const EdgePiece& p : pieces)
    if (p.low <= place && place <= p.high) least = std::min(least, p.at(place));
  return least;
}

/// The fan, and the least distance that came so far to places of it, told from vertex 0.
class FanEnvelopeTest : public testing::Test {
 protected:
  static constexpr int places = 200;

  double length() const { return surface->length(edges.front()); }
  double place(int i) const { return length() * (i + 0.5) / places; }
  /// The same place in the frame of a half-edge that runs against `edge`.
  double place_against(Index edge, int i) const { return begins_at_0(edge) ? length() - place(i) : place(i); }
  bool begins_at_0(Index edge) const { return surface->original_vertex(surface->from(edge)) == 0; }

  const std::shared_ptr<const PackedMesh> surface = fan_of_five();
  const std::vector<Index> edges = half_edges_of_the_fan(*surface);
  FanEnvelope envelope{*surface};
};

/// A part is left exactly where a piece is nearer than all that came before, from whichever face.
TEST_F(FanEnvelopeTest, LeavesWhatIsNearerThanAllThatCameBefore) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    shapes::Random random(seed);
    envelope.reset();
    std::vector<double> least(places, infinity);
    for (int round = 0; round < 12; ++round) {
      const Index edge = edges[random.index(edges.size())];
      const EdgePieces given = random_pieces(length(), random);
      EdgePieces left = given;
      envelope.claim(edge, left);
      for (int i = 0; i < places; ++i) {
        const double x = place_against(edge, i), came = distance_at(given, x);
        const bool wins = came < least[i] * (1 - 1e-9), loses = !(came < least[i] * (1 + 1e-9));
        if (wins) ASSERT_EQ(distance_at(left, x), came) << "seed " << seed << " round " << round << " at " << x;
        if (loses) ASSERT_EQ(distance_at(left, x), infinity) << "seed " << seed << " round " << round << " at " << x;
        least[i] = std::min(least[i], came);
      }
    }
  }
}

/// From any half-edge, so that frames are mirrored to and fro: rounding must not make a piece lose to itself.
TEST_F(FanEnvelopeTest, KeepsWhatNothingNearerCameTo) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    shapes::Random random(seed);
    envelope.reset();
    const Index edge = edges[random.index(edges.size())];
    EdgePiece piece{random.uniform(0, length()), -std::pow(10, random.uniform(-16, 0)), 0, 0, length(), 7};
    EdgePieces pieces{piece};
    envelope.claim(edge, pieces);
    ASSERT_EQ(pieces.size(), 1u);
    for (const Index other : edges) {
      const bool mirrored = surface->from(other) == surface->from(edge);
      EdgePieces waiting = pieces;
      if (mirrored) waiting[0].x = length() - waiting[0].x;
      envelope.keep_nearest(other, waiting);
      ASSERT_EQ(waiting.size(), 1u) << "seed " << seed;
      ASSERT_EQ(waiting[0].number, 7u);
      ASSERT_LE(waiting[0].low, 1e-12);
      ASSERT_GE(waiting[0].high, length() - 1e-12);
    }
  }
}

TEST_F(FanEnvelopeTest, DropsWhatSomethingNearerCameTo) {
  EdgePieces first{{0.5, -1, 1, 0, length(), 0}}, second{{0.5, -1, 0.5, 0, 0.5, 0}};
  envelope.claim(edges[0], first);
  envelope.claim(edges[0], second);
  const Index against =
      *std::find_if(edges.begin(), edges.end(), [&](Index h) { return surface->from(h) != surface->from(edges[0]); });
  EdgePieces waiting{{0.5, -1, 1, 0, length(), 0}};
  envelope.keep_nearest(against, waiting);
  ASSERT_EQ(waiting.size(), 1u);
  EXPECT_DOUBLE_EQ(waiting[0].low, 0.5);
  EXPECT_DOUBLE_EQ(waiting[0].high, length());
}

TEST_F(FanEnvelopeTest, LeavesNothingOfADuplicateFromAnotherFace) {
  EdgePieces pieces{{0.4, -0.3, 1, 0.1, 0.9, 0}}, again{{length() - 0.4, -0.3, 1, length() - 0.9, length() - 0.1, 0}};
  const Index against =
      *std::find_if(edges.begin(), edges.end(), [&](Index h) { return surface->from(h) != surface->from(edges[0]); });
  envelope.claim(edges[0], pieces);
  envelope.claim(against, again);
  for (const EdgePiece& p : again) EXPECT_LE(p.high - p.low, 1e-15);
}

/// Rays of an image that lies on the edge cross it at one place, whatever places the piece names.
TEST_F(FanEnvelopeTest, LeavesAnImageOnTheEdgeWhole) {
  EdgePieces there{{0.5, -1, 0.4, 0, 0.5, 0}}, close{{0.5, 0, 1, 0, length(), 0}};
  envelope.claim(edges[0], there);
  envelope.claim(edges[0], close);
  ASSERT_EQ(close.size(), 1u);
  EXPECT_EQ(close[0].low, 0);
  EXPECT_EQ(close[0].high, length());
}

}  // namespace
}  // namespace geodrome::test
