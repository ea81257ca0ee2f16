// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geodrome/engine/observer.hpp"

namespace geodrome {

/// The end of a process that took no more than the step it was at with it.
struct LostStep {
  std::string reason;  ///< in words
  int status = 0;      ///< the exit status that it stands for
};

/// Work in processes of its own. A plugin that crashes, aborts, ends its process or is killed there takes down the step
/// that it was called in, and nothing else.
///
/// What a process knows cannot be handed back by one that died, so it is handed on: before a step the process makes a
/// copy of itself (fork), which takes the step and all later ones while the original sleeps. If the copy dies before it
/// has made another, the original wakes up where it was, and goes on without that step. A copy shares its memory with
/// the original until one of them changes it.
class Apart {
 public:
  using Strings = std::vector<std::string>;
  /// Gives the result. `observer` tells the one of `run`.
  using Work = std::function<Strings(Apart& apart, Observer& observer)>;

  /// Runs `work` in a child process, with handlers for crashes there, and returns its result; throws what it throws, by
  /// the same kind, and PluginError if all of it dies. `observer` is told, and asked whether to cancel, on this thread.
  /// No process outlives the call, nor the death of the caller. Output streams are flushed first. A program with other
  /// threads must not load plugins in them meanwhile.
  static Strings run(const Work& work, Observer& observer);

  /// To be called by `work` before a step. Returns nothing to the process that is to take it; returns how that one died
  /// if it did. Where no process can be made, which is told to the observer, the step is taken by this one.
  std::optional<LostStep> before_step();

 private:
  struct Shared;
  Apart(Shared& shared, Observer& observer) : shared_(shared), observer_(observer) {}
  [[noreturn]] static void serve(const Work& work, const Observer& first, Shared& shared, int descriptor);

  Shared& shared_;
  Observer& observer_;
};

}  // namespace geodrome
