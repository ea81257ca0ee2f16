// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <pty.h>

#include <cstdlib>

#include "tests/support/npy.hpp"
#include "tests/support/program.hpp"

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

  /// Runs `geodrome` with all three streams on a terminal and gives what it wrote there.
  std::string on_terminal(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), std::string(GEODROME_BINARY_DIR) + "/bin/geodrome");
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    int terminal = -1;
    const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
    if (child == 0) {
      execv(argv[0], argv.data());
      _exit(127);
    }
    std::string text;
    char block[4096];
    for (ssize_t count = 0; (count = read(terminal, block, sizeof block)) > 0;)  // EIO once the program has ended
      text.append(block, static_cast<std::size_t>(count));
    close(terminal);
    waitpid(child, nullptr, 0);
    return text;
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

TEST_F(Streams, TheLineOfProgressIsGoneBeforeTheResultIsPrinted) {
  ASSERT_EQ(run("shape bumpy --mesh --faces 2000 -o b.ply", "> out"), 0);
  std::string sources = "0";
  for (int i = 1; i < 300; ++i) sources += "," + std::to_string(i);
  const std::string text = on_terminal({"distances", (folder_ / "b.ply").string(), "--audit", "0", "--threads", "1",
                                        "-o", (folder_ / "d.npy").string(), "--solver", "cgal", "--sources", sources});
  const std::string cleared = "\r\033[K";
  const std::size_t progress = text.rfind("distances "), summary = text.find("input      ");
  ASSERT_NE(summary, std::string::npos) << text;
  if (progress == std::string::npos) GTEST_SKIP() << "took less than the second after which progress is shown";
  EXPECT_LT(progress, summary);
  EXPECT_EQ(text.substr(summary - cleared.size(), cleared.size()), cleared) << text;
}

}  // namespace
