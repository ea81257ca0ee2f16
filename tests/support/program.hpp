// SPDX-License-Identifier: MIT
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.hpp"

namespace geodrome::testing {

inline std::string read_bytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

struct Outcome {
  int status = -1;  ///< exit status; 128 + signal if killed
  std::string out, err;
};

/// A program of the build, started with its output in files of a folder.
class RunningProgram {
 public:
  RunningProgram(const TemporaryFolder& folder, const std::string& program, const std::vector<std::string>& arguments)
      : out_((folder / "stdout").string()), err_((folder / "stderr").string()) {
    const std::string path = std::string(GEODROME_BINARY_DIR) + "/bin/" + program;
    std::vector<char*> argv{const_cast<char*>(path.c_str())};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    child_ = fork();
    if (child_ != 0) return;
    if (!std::freopen(out_.c_str(), "w", stdout) || !std::freopen(err_.c_str(), "w", stderr)) _exit(126);
    execv(path.c_str(), argv.data());
    _exit(127);
  }

  void send(int signal) const { kill(child_, signal); }

  Outcome wait() {
    int status = 0;
    waitpid(child_, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_bytes(out_), read_bytes(err_)};
  }

 private:
  std::string out_, err_;
  pid_t child_ = -1;
};

/// Runs `geodrome` with the arguments and waits.
inline Outcome run_geodrome(const TemporaryFolder& folder, const std::vector<std::string>& arguments) {
  return RunningProgram(folder, "geodrome", arguments).wait();
}

}  // namespace geodrome::testing
