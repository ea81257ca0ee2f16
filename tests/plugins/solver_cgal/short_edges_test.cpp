// SPDX-License-Identifier: MIT
// The guard before CGAL is called. What CGAL cannot take is not tried here: a larger share counts as lost, so that
// sound meshes have edges without length, and a stand-in tells whether CGAL would have been called.
#include "plugins/solver_cgal/short_edges.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "geodrome/errors.hpp"
#include "tools/shapes/small_meshes.hpp"

namespace geodrome::cgal {
namespace {

/// A strip of two squares, all of whose vertices lie on the boundary; the middle edge is 0.01 long.
MeshPtr strip() {
  return std::make_shared<const SurfaceMesh>(
      std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 0.01, 0}, {2, 1, 0}},
      std::vector<Triangle>{{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}});
}

/// A double pyramid: no boundary, and every total angle is below 2 pi. Edges of its belt are 0.1 long.
MeshPtr spindle() {
  return std::make_shared<const SurfaceMesh>(
      std::vector<Vec3>{{0, 0, 5}, {0, 0, -5}, {0.1, 0, 0}, {0, 0.1, 0}, {-0.1, -0.1, 0}},
      std::vector<Triangle>{{0, 2, 3}, {0, 3, 4}, {0, 4, 2}, {1, 3, 2}, {1, 4, 3}, {1, 2, 4}});
}

constexpr double a_thousandth = 1e-3, a_tenth = 0.1;

TEST(ShortEdges, OfABoundaryAreFoundOnce) {
  const std::vector<Index> found = edges_without_length(*strip(), a_thousandth);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0], 1u) << "of face 0, from vertex 1 to vertex 4";
}

TEST(ShortEdges, BetweenVerticesThatStartNoWindowsDoNotMatter) {
  EXPECT_TRUE(edges_without_length(*spindle(), a_tenth).empty());
}

TEST(ShortEdges, FlatVerticesStartWindows) {
  const MeshPtr grid = shapes::small::plane_grid(4);
  std::size_t edges = 0;
  for (Index h = 0; h < 3 * grid->face_count(); ++h) edges += grid->twins()[h] == no_index || h < grid->twins()[h];
  EXPECT_EQ(edges_without_length(*grid, 1).size(), edges);
}

TEST(ShortEdges, WithUsualLengthsThereAreNone) {
  EXPECT_TRUE(edges_without_length(*strip(), lost_share).empty());
  EXPECT_TRUE(edges_without_length(*shapes::small::plane_grid(4), lost_share).empty());
}

TEST(ShortEdges, AreRefusedByNameBeforeTheLibraryIsCalled) {
  bool called = false;
  const auto stand_in = [&] { return called = true; };
  try {
    with_lengths(*strip(), a_thousandth, stand_in);
    FAIL() << "not refused";
  } catch (const CapabilityError& error) {
    EXPECT_NE(error.message().find("1 edge without length"), std::string::npos) << error.message();
    EXPECT_NE(error.message().find("vertices 1 and 4 of face 0 and face 3"), std::string::npos) << error.message();
    EXPECT_FALSE(error.remedy().empty());
  }
  EXPECT_FALSE(called);
  EXPECT_TRUE(with_lengths(*strip(), lost_share, stand_in));
}

}  // namespace
}  // namespace geodrome::cgal
