// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

#include "geodrome/errors.hpp"

namespace geodrome {

/// The weight of a line of the log: `debug` lines are seen by those who ask, `warning` by everybody.
enum class LogLevel { debug, info, warning };

/// The host as a plugin may ask it and tell it things while it works. Every member is safe to call from any thread.
class GEODROME_VISIBLE RunContext {
 public:
  virtual ~RunContext() = default;

  /// Share of the stage's work done, in [0, 1]; cheap enough to call a thousand times a stage.
  virtual void progress(double fraction) = 0;
  /// Tells whether the user asked to stop; once true it stays so. Cheap enough for every turn of a loop.
  virtual bool cancelled() const noexcept = 0;
  /// Tells the user one sentence, without a line break and without the plugin's name, which the host puts before it.
  /// The text is copied. For what must be seen in a result, return a finding.
  virtual void log(LogLevel level, std::string_view message) = 0;
  /// Puts a named figure of this stage into the run report; the last value of a name stays.
  virtual void measure(std::string_view name, double value) = 0;
  /// Returns the number of threads that the plugin may use, at least 1. The result must not depend on it.
  virtual unsigned threads() const noexcept = 0;
  /// The only source of randomness.
  virtual std::uint64_t seed() const noexcept = 0;

  /// Long loops call this; throws Cancelled once the user asked to stop.
  void throw_if_cancelled() const {
    if (cancelled()) throw Cancelled();
  }
};

/// One thread, seed 0, never cancelled, tells nobody: for tests and for short calls.
class GEODROME_VISIBLE QuietContext : public RunContext {
 public:
  void progress(double) override {}
  bool cancelled() const noexcept override { return false; }
  void log(LogLevel, std::string_view) override {}
  void measure(std::string_view, double) override {}
  unsigned threads() const noexcept override { return 1; }
  std::uint64_t seed() const noexcept override { return 0; }
};

}  // namespace geodrome
