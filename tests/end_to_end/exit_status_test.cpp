// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/support/program.hpp"

namespace {

using namespace geodrome::testing;

class ExitStatus : public ::testing::Test {
 protected:
  void SetUp() override {
    write_bytes(folder_ / "m.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  }
  Outcome run(const std::vector<std::string>& arguments) { return run_geodrome(folder_, arguments); }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  std::string mesh() const { return file("m.off"); }

  void expect(const Outcome& outcome, int status, const std::string& word) {
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
  }

  TemporaryFolder folder_;
};

TEST_F(ExitStatus, IsTwoForUsage) {
  expect(run({"distances", mesh(), "--no-such-option"}), 2, "no-such-option");
  expect(run({"distances", mesh(), "-o", file("d.npy"), "--solver", "no_such"}), 2, "cgal");
  expect(run({"distances", mesh(), "-o", file("d.npy"), "--solver", "cgal:k=1"}), 2, "k");
  expect(run({"distances", mesh(), "-o", file("d.npy"), "--sources", "0,4"}), 2, "row 4");
  expect(run({"distances", mesh(), "-o", file("d.txt")}), 2, ".npy");
  expect(run({"distances", mesh()}), 2, "-o FILE");
  expect(run({}), 2, "subcommand");
}

TEST_F(ExitStatus, IsThreeForBadInputAndUnwritableOutput) {
  expect(run({"distances", file("no.off"), "-o", file("d.npy")}), 3, "no.off");
  expect(run({"distances", mesh(), "-o", file("no/d.npy")}), 3, "no/d.npy");
  write_bytes(folder_ / "list.txt", "0\n1 2\n");
  expect(run({"distances", mesh(), "-o", file("d.npy"), "--sources", "@" + file("list.txt")}), 3, "line 2");
}

/// Names that the system cannot look up: too long, or links in a circle.
TEST_F(ExitStatus, IsTwoOrThreeForNamesThatCannotBe) {
  const std::string name(300, 'a');
  std::filesystem::create_symlink("loop", folder_ / "loop");
  for (const std::string& solver : {"./" + name + ".so", file("loop") + "/a.so"})
    expect(run({"distances", mesh(), "-o", file("d.npy"), "--solver", solver}), 2, "is not there");
  expect(run({"plugins", "show", "./" + name}), 2, "is not there");
  write_bytes(folder_ / "p.txt", "0, 1\n");
  expect(run({"queries", mesh(), "--pairs", file("p.txt"), "-o", file("d.npy"), "--solver", "aleksandrov", "--index",
              file(name)}),
         3, "cannot examine");
  expect(run({"distances", mesh(), "--sources", "0", "-o", file(name + ".npy")}), 3, "cannot be written");
  // The file itself may have that name, those that are needed while it grows may not.
  const std::string longest = file(std::string(240, 'a') + ".npy");
  expect(run({"distances", mesh(), "--sources", "0", "-o", longest}), 3, "cannot write");
  EXPECT_FALSE(std::filesystem::exists(longest + ".partial"));
}

TEST_F(ExitStatus, IsThreeForNeedsAndProvidesThatAreNotMet) {
  write_bytes(folder_ / "book.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n");
  expect(run({"distances", file("book.off"), "-o", file("d.npy"), "--solver", "cgal"}), 3, "nonmanifold");
  write_bytes(folder_ / "late.txt", "0 + 1\n2\n");
  expect(
      run({"distances", mesh(), "--nearest", file("n.csv"), "--solver", "heat", "--sources", "@" + file("late.txt")}),
      3, "start_distances");
}

TEST_F(ExitStatus, IsFourForAMatrixAboveFourGigabytesWithoutConsent) {
  ASSERT_EQ(run({"shape", "plane", "--mesh", "--faces", "50000", "-o", file("p.ply")}).status, 0);
  expect(run({"distances", file("p.ply"), "-o", file("d.npy"), "--solver", "edge_dijkstra"}), 4, "--yes");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "d.npy.partial"));
}

TEST_F(ExitStatus, IsFourForASampleThatIsNotFit) {
  write_bytes(folder_ / "line.xyz", "0 0 0\n1 1 1\n2 2 2\n3 3 3\n4 4 4\n");
  expect(run({"distances", file("line.xyz"), "-o", file("d.npy")}), 4, "tangent_jet");
}

TEST_F(ExitStatus, IsFiveForDistancesThatBreakAPromise) {
  write_bytes(folder_ / "two.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n5 0 0\n6 0 0\n5 1 0\n3 0 1 2\n3 3 4 5\n");
  const std::string plugins = std::string(GEODROME_BINARY_DIR) + "/tests/sound_plugins";
  expect(
      run({"distances", file("two.off"), "-o", file("d.npy"), "--solver", "test_straight", "--plugin-path", plugins}),
      5, "18 distances between components are numbers");
}

TEST_F(ExitStatus, IsZeroForHelpAndVersion) {
  EXPECT_EQ(run({"--help"}).status, 0);
  EXPECT_EQ(run({"distances", "--help"}).status, 0);
  EXPECT_NE(run({"--version"}).out.find("geodrome 0."), std::string::npos);
}

}  // namespace
