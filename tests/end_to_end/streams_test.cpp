// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>

#include "support/npy.hpp"
#include "support/program.hpp"

namespace {

using namespace geodrome::testing;

/// Standard streams that are closed, full or a terminal, as only a shell can arrange them.
class Streams : public ::testing::Test {
 protected:
  void SetUp() override {
    write_bytes(folder_ / "m.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  }

  /// Runs `geodrome ARGUMENTS` with a shell's redirections and gives its exit status.
  int run(const std::string& arguments, const std::string& redirections) {
    const std::string command = "cd '" + folder_.path().string() + "' && '" + GEODROME_BINARY_DIR + "/bin/geodrome' " +
                                arguments + " " + redirections;
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  TemporaryFolder folder_;
};

TEST_F(Streams, ClosedOnesPutNoMessageIntoTheMatrix) {
  const std::string job = "distances m.off --solver edge_dijkstra -o ";
  ASSERT_EQ(run(job + "whole.npy", "> out 2> err"), 0);
  EXPECT_EQ(run(job + "no_err.npy", "> out 2>&-"), 0);
  run(job + "no_streams.npy", "<&- >&- 2>&-");
  EXPECT_EQ(read_bytes(folder_ / "no_err.npy"), read_bytes(folder_ / "whole.npy"));
  EXPECT_EQ(read_bytes(folder_ / "no_streams.npy"), read_bytes(folder_ / "whole.npy"));
}

TEST_F(Streams, OutputThatCannotBeWrittenIsStatusThree) {
  EXPECT_EQ(run("check m.off", "> /dev/full 2> err"), 3);
  EXPECT_NE(read_bytes(folder_ / "err").find("standard output"), std::string::npos);
  EXPECT_EQ(run("check m.off --json", ">&- 2> err"), 3);
  EXPECT_EQ(run("--help", "> /dev/full 2> err"), 3);
}

}  // namespace
