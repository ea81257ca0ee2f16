// SPDX-License-Identifier: MIT
#include "tests/faults/lab.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <thread>

#include "tests/support/program.hpp"

namespace geodrome::faults {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

/// A run that takes longer hangs: the jobs take tenths of a second.
constexpr auto longest = 60s;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

void limit(int resource, rlim_t value) {
  if (value == RLIM_INFINITY) return;
  const rlimit both{value, value};
  setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

/// Puts the file in the place of a standard stream of this process.
void redirect(int stream, const std::string& file) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (descriptor < 0 || dup2(descriptor, stream) < 0) _exit(126);
}

/// A pipe whose reader is gone.
void redirect_to_nobody(int stream) {
  int ends[2];
  if (pipe(ends) != 0 || dup2(ends[1], stream) < 0) _exit(126);
  close(ends[0]);
}

std::string replaced(std::string text, const std::string& by) {
  for (std::size_t at = 0; (at = text.find('%', at)) != std::string::npos; at += by.size()) text.replace(at, 1, by);
  return text;
}

int wait_for(pid_t child, const Conditions& conditions) {
  const auto begin = Clock::now();
  bool signalled = conditions.signal == 0;
  for (int status = 0;;) {
    if (waitpid(child, &status, WNOHANG) == child)
      return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    const double now = seconds_since(begin);
    if (!signalled && now >= conditions.after) signalled = true, kill(child, conditions.signal);
    if (now > std::chrono::duration<double>(longest).count()) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      return Ended::hangs;
    }
    std::this_thread::sleep_for(signalled ? 1ms : 200us);
  }
}

}  // namespace

std::string Fault::text() const {
  std::string text = call + " number " + std::to_string(at) + (path.empty() ? "" : " on " + path);
  if (times != 1) text += times == 0 ? " and all after it" : " and " + std::to_string(times - 1) + " after it";
  if (!act.empty()) return text + ": " + act;
  return text + (shortened >= 0 ? ": " + std::to_string(shortened) + " bytes at most"
                                : ": " + std::string(std::strerror(error)));
}

Lab::Lab(std::string program, const fs::path& place)
    : program_(std::move(program)), folder_((place.empty() ? records_.path() : place) / "work") {
  fs::create_directory(folder_);
}

void Lab::prepare(const Job& job, const std::string& old) {
  for (const auto& entry : fs::directory_iterator(folder_)) fs::remove_all(entry.path());
  for (const std::string& name : job.reads) {
    testing::write_bytes(path(name), inputs_.at(name));
    // Long ago, so that every change during the run shows in the time of change, however coarse that is.
    fs::last_write_time(path(name), fs::file_time_type::clock::now() - 1h);
  }
  for (const auto& [name, bytes] : job.before) testing::write_bytes(path(name), bytes);
  if (!old.empty())
    for (const std::string& name : job.outputs) testing::write_bytes(path(name), old);
}

Ended Lab::run(const std::vector<std::string>& arguments, const Conditions& conditions) const {
  const std::string out = (records_ / "out").string(), err = (records_ / "err").string(),
                    log = (records_ / "log").string();
  fs::remove(log), fs::remove(out);
  std::string plan;
  if (const auto& fault = conditions.fault)
    plan = "call=" + fault->call +
           ";path=" + (fault->call == "malloc" || fault->call == "thread" ? "" : path(fault->path).string()) +
           ";at=" + std::to_string(fault->at) + ";times=" + std::to_string(fault->times) +
           ";errno=" + std::to_string(fault->error) + ";short=" + std::to_string(fault->shortened) +
           ";act=" + fault->act + ";log=" + log;
  std::vector<std::string> words{program_};
  for (const std::string& argument : arguments) words.push_back(replaced(argument, folder_.string() + "/"));
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const auto begin = Clock::now();
  const pid_t child = fork();
  if (child == 0) {
    redirect(STDERR_FILENO, err);
    conditions.out == "closed" ? redirect_to_nobody(STDOUT_FILENO)
                               : redirect(STDOUT_FILENO, conditions.out.empty() ? out : conditions.out);
    if (!plan.empty()) setenv("GEODROME_FAULT", plan.c_str(), 1), setenv("LD_PRELOAD", GEODROME_FAULT_SHIM, 1);
    if (conditions.ignored != 0) std::signal(conditions.ignored, SIG_IGN);
    limit(RLIMIT_AS, conditions.address_space);
    limit(RLIMIT_FSIZE, conditions.file_size);
    execv(program_.c_str(), argv.data());
    _exit(127);
  }
  Ended ended{.status = wait_for(child, conditions)};
  ended.seconds = seconds_since(begin);
  ended.out = testing::read_bytes(out), ended.err = testing::read_bytes(err);
  const std::string calls = testing::read_bytes(log);
  ended.calls = calls.size(), ended.struck = calls.find('F') != std::string::npos;
  return ended;
}

Files Lab::files() const {
  Files files;
  for (const auto& entry : fs::directory_iterator(folder_))
    files[entry.path().filename().string()] = testing::read_bytes(entry.path());
  return files;
}

void Lab::make(const std::string& name, const std::vector<std::string>& arguments) {
  const Ended ended = run(arguments);
  if (ended.status != 0) throw std::runtime_error("cannot make " + name + ": " + ended.err);
  add(name, testing::read_bytes(path(name)));
}

}  // namespace geodrome::faults
