// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <string>

#include "geodrome/engine/observer.hpp"
#include "geodrome/run_context.hpp"

namespace geodrome {

/// The RunContext that a plugin sees: hands everything on to the observer under the stage's name, keeps the measures.
class StageContext final : public RunContext {
 public:
  StageContext(std::string stage, Observer& observer, unsigned threads, std::uint64_t seed)
      : stage_(std::move(stage)), observer_(observer), threads_(threads), seed_(seed) {}

  void progress(double fraction) override { observer_.progress(stage_, fraction); }
  bool cancelled() const noexcept override { return observer_.cancelled(); }
  void log(LogLevel level, std::string_view message) override {
    observer_.log(level, stage_ + ": " + std::string(message));
  }
  void measure(std::string_view name, double value) override {
    const std::lock_guard lock(mutex_);
    measures_[std::string(name)] = value;
  }
  unsigned threads() const noexcept override { return threads_; }
  std::uint64_t seed() const noexcept override { return seed_; }

  std::map<std::string, double> measures() const {
    const std::lock_guard lock(mutex_);
    return measures_;
  }

 private:
  std::string stage_;
  Observer& observer_;
  unsigned threads_;
  std::uint64_t seed_;
  mutable std::mutex mutex_;
  std::map<std::string, double> measures_;
};

/// Seconds since it was made.
class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace geodrome
