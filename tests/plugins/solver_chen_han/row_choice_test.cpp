// SPDX-License-Identifier: MIT
#include "tests/plugins/solver_chen_han/rows_fixture.hpp"

/// When lists of direct paths are made, and what is told where they are not.
namespace geodrome::test {
namespace {

struct Choice {
  bool lists;
  std::string told;
};

Choice choose(const MeshPtr& mesh, const std::string& options, std::size_t sources = 1000000,
              double radius = infinity) {
  std::vector<SurfacePoint> all = all_vertices(*mesh);
  if (all.size() > sources) all.resize(sources);
  const Planned planned(mesh, all, radius, options);
  return {static_cast<bool>(planned), planned.told()};
}

void expect_plain(const Choice& choice, const std::string& reason) {
  EXPECT_FALSE(choice.lists) << choice.told;
  EXPECT_TRUE(choice.told.starts_with("every row by a search of its own: ")) << choice.told;
  EXPECT_NE(choice.told.find(reason), std::string::npos) << choice.told;
}

TEST(RowChoice, TakesListsOnRoughMeshes) {
  for (const char* kind : {"noisy-sphere", "bumpy"}) {
    const Choice choice = choose(shape(kind, 5000), "rows=auto");
    if (std::string_view(kind) == "bumpy") {
      expect_plain(choice, "of the work of plain searches");
    } else {
      EXPECT_TRUE(choice.lists) << choice.told;
      EXPECT_NE(choice.told.find("lists of direct paths, about "), std::string::npos) << choice.told;
    }
  }
}

TEST(RowChoice, LeavesConvexMeshesToPlainSearches) {
  expect_plain(choose(shape("icosphere", 1280), "rows=auto"), "no path bends at a vertex");
  expect_plain(choose(shape("icosphere", 1280), "rows=lists"), "no path bends at a vertex");
}

TEST(RowChoice, LeavesFewSourcesToPlainSearches) {
  const MeshPtr mesh = shape("noisy-sphere", 20000);
  expect_plain(choose(mesh, "rows=auto", 63), "64 sources");
  expect_plain(choose(mesh, "rows=auto", 70), "so few or so short searches");
  EXPECT_TRUE(choose(shape("noisy-sphere", 500), "rows=lists", 1).lists);
}

TEST(RowChoice, IsLeftToTheUser) {
  const MeshPtr rough = shape("noisy-sphere", 5000), smooth = shape("jittered-torus", 1000);
  expect_plain(choose(rough, "rows=plain"), "the option rows says so");
  EXPECT_TRUE(choose(smooth, "rows=lists").lists);
  expect_plain(choose(rough, "rows=lists,filter=off"), "filter=on");
}

TEST(RowChoice, TakesNoMoreMemoryThanAllowed) {
  const MeshPtr mesh = shape("noisy-sphere", 20000);
  expect_plain(choose(mesh, "rows=lists,lists_memory=1"), "lists_memory allows 1");
  EXPECT_THROW(load_solver("chen_han:lists_memory=0"), OptionError);
  EXPECT_THROW(load_solver("chen_han:rows=all"), OptionError);
}

/// The sample is one of the many sources on the terrain, whose paths are few.
TEST(RowChoice, GivesListsUpThatOutgrowTheirEstimate) {
  const MeshPtr sheet = shapes::small::plane_grid(60), hills = shapes::small::terrain(10, 1, 2);
  std::vector<Triangle> rest;
  for (Index f = 0; f < sheet->face_count(); ++f) {
    const Vec3 p = (1.0 / 3) * (sheet->corners(f)[0] + sheet->corners(f)[1] + sheet->corners(f)[2]);
    if (static_cast<int>(p.x) % 4 != 1 || static_cast<int>(p.y) % 4 != 1) rest.push_back(sheet->triangles()[f]);
  }
  const MeshPtr holes = shapes::small::make({sheet->positions().begin(), sheet->positions().end()}, rest);
  const MeshPtr mesh = shapes::small::both(holes, hills);
  std::vector<SurfacePoint> sources{mesh->at_vertex(0)};
  for (Index i = 0; i < 30; ++i) sources.push_back(mesh->at_vertex(static_cast<Index>(holes->vertex_count()) + 3 * i));
  const Planned planned(mesh, sources, infinity, "rows=lists,lists_memory=1");
  EXPECT_FALSE(planned);
  ASSERT_EQ(planned.lines().size(), 2U);
  EXPECT_TRUE(planned.lines()[0].starts_with("rows by ")) << planned.lines()[0];
  EXPECT_EQ(planned.lines()[1],
            "the lists of direct paths grew larger than estimated, beyond the 1 MiB that lists_memory allows: they are "
            "given up, every row by a search of its own");
  EXPECT_TRUE(Planned(mesh, sources, infinity, "rows=lists,lists_memory=100"));
}

TEST(RowChoice, DoesNotDependOnTheOrderOfSources) {
  const MeshPtr mesh = shapes::small::bumpy_torus(20, 14, 0.15, 1);
  std::vector<SurfacePoint> all = all_vertices(*mesh);
  const Planned there(mesh, all);
  std::reverse(all.begin(), all.end());
  const Planned back(mesh, all);
  EXPECT_EQ(there.told(), back.told());
  EXPECT_EQ(there.surface().bytes(), back.surface().bytes());
}

}  // namespace
}  // namespace geodrome::test
