// SPDX-License-Identifier: MIT
#include "tools/bench/memory_peak.hpp"

#include <fstream>
#include <string>

namespace geodrome::bench {

std::size_t memory_peak() {
  constexpr std::size_t kilobyte = 1024;
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::size_t amount = 0;
    if (word == "VmHWM:" && status >> amount) return amount * kilobyte;
  }
  return 0;
}

bool reset_memory_peak() {
  std::ofstream references("/proc/self/clear_refs");
  references << "5" << std::flush;  // proc(5): resets the peak resident set size
  return static_cast<bool>(references);
}

}  // namespace geodrome::bench
