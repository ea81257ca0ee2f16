// SPDX-License-Identifier: MIT
#include "engine/host/child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>

#include "geodrome/errors.hpp"

namespace geodrome {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t largest_output = 1 << 20;

/// A machine that has too little of something is not the plugin's fault.
[[noreturn]] void fail(const std::string& what, int error) {
  const std::string message = what + ": " + std::strerror(error);
  if (error == ENOMEM || error == EAGAIN || error == EMFILE || error == ENFILE)
    throw RefusedError(message, "close other programs, or raise the limits of the system (ulimit -a)");
  throw PluginError(message);
}

/// Both ends are closed on exec; the child gets its end by a dup2 among the spawn actions.
struct Pipe {
  int read_end = -1, write_end = -1;
  Pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) fail("cannot make a pipe", errno);
    read_end = ends[0], write_end = ends[1];
  }
  ~Pipe() {
    close(read_end);
    close_write_end();
  }
  void close_write_end() {
    if (write_end >= 0) close(write_end);
    write_end = -1;
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
};

struct SpawnPlan {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;

  SpawnPlan(int out, int err) {
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, err, STDERR_FILENO);
    // A process group of its own, so that it can be killed with what it started; signals as in a fresh process.
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~SpawnPlan() {
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;
};

pid_t spawn(const std::filesystem::path& program, const std::vector<std::string>& arguments, const SpawnPlan& plan) {
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  pid_t child = 0;
  const int error = posix_spawn(&child, program.c_str(), &plan.actions, &plan.attributes, argv.data(), environ);
  if (error != 0) fail("cannot run " + program.string(), error);
  return child;
}

int milliseconds_until(Clock::time_point deadline) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return static_cast<int>(std::max<std::int64_t>(0, left));
}

/// Appends what can be read now; false at the end of the stream.
bool drain(int descriptor, std::string& text) {
  char buffer[4096];
  const ssize_t count = read(descriptor, buffer, sizeof buffer);
  if (count < 0) return errno == EINTR;
  text.append(buffer, std::min<std::size_t>(count, largest_output - std::min(largest_output, text.size())));
  return count > 0;
}

/// Reads both streams until their ends or the deadline.
void collect(const Pipe& out, const Pipe& err, Clock::time_point deadline, ChildEnd& end) {
  pollfd streams[] = {{out.read_end, POLLIN, 0}, {err.read_end, POLLIN, 0}};
  std::string* texts[] = {&end.out, &end.err};
  while (streams[0].fd >= 0 || streams[1].fd >= 0) {
    const int ready = poll(streams, 2, milliseconds_until(deadline));
    if (ready == 0) return;
    if (ready < 0) continue;  // interrupted
    for (int i = 0; i < 2; ++i)
      if (streams[i].fd >= 0 && streams[i].revents != 0 && !drain(streams[i].fd, *texts[i])) streams[i].fd = -1;
  }
}

/// Waits for the child's end until the deadline; false if it still runs.
bool reap(pid_t child, Clock::time_point deadline, ChildEnd& end) {
  for (;;) {
    int status = 0;
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended < 0 && errno != EINTR) fail("cannot learn how a plugin's test run ended", errno);
    if (ended == child) {
      end.exited = WIFEXITED(status);
      if (end.exited)
        end.status = WEXITSTATUS(status);
      else
        end.signal = WTERMSIG(status);
      return true;
    }
    if (Clock::now() >= deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

}  // namespace

ChildEnd run_child(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                   std::chrono::milliseconds limit) {
  const auto deadline = Clock::now() + limit;
  Pipe out, err;
  const SpawnPlan plan(out.write_end, err.write_end);
  const pid_t child = spawn(program, arguments, plan);
  out.close_write_end();
  err.close_write_end();
  ChildEnd end;
  collect(out, err, deadline, end);
  if (!reap(child, deadline, end)) {
    end.timed_out = true;
    kill(-child, SIGKILL);
    while (waitpid(child, nullptr, 0) < 0 && errno == EINTR) continue;
  }
  return end;
}

std::string last_words(const ChildEnd& end) {
  constexpr std::size_t longest = 300;
  const std::size_t last = end.err.find_last_not_of(" \t\r\n");
  if (last == std::string::npos) return {};
  const std::size_t first = end.err.find_last_of('\n', last) + 1;
  return " (it said: " + end.err.substr(first, std::min(longest, last + 1 - first)) + ")";
}

std::string signal_name(const ChildEnd& end) {
  const char* name = sigabbrev_np(end.signal);
  return name ? "SIG" + std::string(name) : "signal " + std::to_string(end.signal);
}

}  // namespace geodrome
