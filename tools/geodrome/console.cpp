// SPDX-License-Identifier: MIT
#include "tools/geodrome/console.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <iostream>

#include "tools/geodrome/remedies.hpp"

namespace geodrome::cli {

namespace {

using namespace std::chrono_literals;

std::atomic<int> interrupts = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler touches it");

void on_interrupt(int) {
  if (++interrupts > 1) _exit(130);
}

/// A signal that the caller has put out of action, as nohup does, stays so.
void stop_on(int signal) {
  if (std::signal(signal, on_interrupt) == SIG_IGN) std::signal(signal, SIG_IGN);
}

}  // namespace

Console::Console(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) stop_on(signal);
}

Console::~Console() { clear_line(); }

bool Console::cancelled() const noexcept { return interrupts > 0; }

void Console::progress(std::string_view stage, double fraction) {
  if (!terminal_ || quiet_) return;
  const std::lock_guard lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (stage != stage_) {
    stage_ = stage;
    stage_began_ = last_shown_ = now;
  }
  if (now - stage_began_ < 1s || now - last_shown_ < 100ms) return;
  last_shown_ = now;
  line_shown_ = true;
  std::fprintf(stderr, "\r\033[K%s %.0f %%", stage_.c_str(), 100 * fraction);
  std::fflush(stderr);
}

void Console::log(LogLevel level, std::string_view message) {
  if (level == LogLevel::debug || (quiet_ && level == LogLevel::info)) return;
  const std::lock_guard lock(mutex_);
  clear_line();
  std::fprintf(stderr, "%s%.*s\n", level == LogLevel::warning ? "warning: " : "", static_cast<int>(message.size()),
               message.data());
}

std::string Console::words(const Remedy& remedy) const { return cli::words(remedy); }

void Console::clear_line() {
  if (line_shown_) std::fprintf(stderr, "\r\033[K");
  line_shown_ = false;
}

int tell(const JobReport& report, const std::string& solver) {
  std::cout << report.summary;
  return tell_broken_promises(report.broken_promises, solver);
}

// Wrong numbers must not look like right ones: not even to a script that reads nothing but the status.
int tell_broken_promises(const std::vector<std::string>& promises, const std::string& solver) {
  if (promises.empty()) return 0;
  for (const std::string& what : promises) std::cerr << "geodrome: broken promise: " << what << "\n";
  std::cerr << "geodrome: do not trust these distances; choose another solver than " << solver
            << ", or check the input\n";
  return 5;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace geodrome::cli
