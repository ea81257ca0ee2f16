// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "geodrome/run_context.hpp"

namespace geodrome::test {

/// Two threads, and the figures that a stage measures.
class RecordingContext : public QuietContext {
 public:
  unsigned threads() const noexcept override { return 2; }
  void measure(std::string_view name, double value) override { measures[std::string(name)] = value; }

  std::map<std::string, double> measures;
};

}  // namespace geodrome::test
