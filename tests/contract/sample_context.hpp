// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/run_context.hpp"

namespace geodrome::test {

/// A context whose every answer a test decides; it keeps what it is told.
class ContractContext : public QuietContext {
 public:
  explicit ContractContext(unsigned threads = 2, std::uint64_t seed = 0) : threads_(threads), seed_(seed) {}
  void progress(double fraction) override {
    if (!(fraction >= 0 && fraction <= 1)) progress_in_range = false;
  }
  bool cancelled() const noexcept override { return stop; }
  unsigned threads() const noexcept override { return threads_; }
  std::uint64_t seed() const noexcept override { return seed_; }

  std::atomic<bool> stop = false, progress_in_range = true;

 private:
  unsigned threads_;
  std::uint64_t seed_;
};

/// The plugins of a stage that the host finds, with default options.
template <class Stage>
std::vector<Plugin<Stage>> plugins_of_stage() {
  const PluginHost host;
  std::vector<Plugin<Stage>> plugins;
  for (const PluginInfo& info : host.list().usable)
    if (info.stage == Stage::stage) plugins.push_back(host.load<Stage>(info.name));
  return plugins;
}

}  // namespace geodrome::test
