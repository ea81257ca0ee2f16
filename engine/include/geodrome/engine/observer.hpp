// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "geodrome/remedy.hpp"
#include "geodrome/run_context.hpp"

namespace geodrome {

/// The caller of the engine while a job runs: hears messages and progress, and may ask the job to stop. Every member
/// may be called from any thread.
class Observer {
 public:
  virtual ~Observer() = default;

  /// `stage` is one of the five stages, or "input", "distances", "invariants", "audit", "oracle", "queries", "truth",
  /// "view", or a combination that is compared; `fraction` in [0, 1].
  virtual void progress(std::string_view /*stage*/, double /*fraction*/) {}
  /// One line for people, without its end.
  virtual void log(LogLevel, std::string_view /*message*/) {}
  /// A remedy as the caller puts it to users of its own, in messages and tables: by its code (see `remedies.hpp`), or
  /// the engine's sentence. Findings in reports hold the sentence and the code.
  virtual std::string words(const Remedy& remedy) const { return remedy.text; }
  /// Asked often; true ends the job with Cancelled.
  virtual bool cancelled() const noexcept { return false; }
};

}  // namespace geodrome
