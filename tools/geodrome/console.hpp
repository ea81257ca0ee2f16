// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <vector>

#include "geodrome/engine/jobs.hpp"

namespace geodrome::cli {

/// Tells a person at a terminal what goes on, on standard error: messages always, progress only on a terminal and only
/// for what takes over a second. Ctrl-C asks the job to stop, as do SIGTERM, SIGHUP and
/// SIGXCPU; a second one ends the program at once.
class Console final : public Observer {
 public:
  explicit Console(bool quiet);
  ~Console() override;

  void progress(std::string_view stage, double fraction) override;
  void log(LogLevel level, std::string_view message) override;
  std::string words(const Remedy& remedy) const override;
  bool cancelled() const noexcept override;

 private:
  void clear_line();

  const bool quiet_, terminal_;
  std::mutex mutex_;
  std::string stage_;
  std::chrono::steady_clock::time_point stage_began_, last_shown_;
  bool line_shown_ = false;
};

/// What a command that runs a job of the engine was told.
template <class Job>
struct JobArguments {
  Job job;
  bool json = false, quiet = false;
};

/// Runs a job. The console is gone when its result is there, and with it the line of progress, so that the result can
/// be printed on the same terminal.
template <class Result, class Job>
Result at_console(Result (*run)(const Job&, Observer&), const JobArguments<Job>& arguments) {
  Console console(arguments.quiet);
  return run(arguments.job, console);
}

/// Prints the summary of a job. Returns its exit status: `tell_broken_promises`.
int tell(const JobReport& report, const std::string& solver);

/// The exit status of a job that broke the promises, 0 if there is none; says on standard error what not to trust.
int tell_broken_promises(const std::vector<std::string>& promises, const std::string& solver);

/// "a, b, c".
std::string joined(const std::vector<std::string>& words);

}  // namespace geodrome::cli
