// SPDX-License-Identifier: MIT
#include "engine/report/memory.hpp"

#include <fstream>
#include <string>
#include <string_view>

namespace geodrome {
namespace {

std::size_t status_bytes(std::string_view name) {
  constexpr std::size_t kilobyte = 1024;
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::size_t amount = 0;
    if (word == name && status >> amount) return amount * kilobyte;
  }
  return 0;
}

}  // namespace

std::size_t memory_peak() { return status_bytes("VmHWM:"); }

std::size_t memory_now() { return status_bytes("VmRSS:"); }

bool reset_memory_peak() {
  std::ofstream references("/proc/self/clear_refs");
  references << "5" << std::flush;  // proc(5): resets the peak resident set size
  return static_cast<bool>(references);
}

}  // namespace geodrome
