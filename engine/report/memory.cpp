// SPDX-License-Identifier: MIT
#include "engine/report/memory.hpp"

#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

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

int make_resident(dl_phdr_info* library, std::size_t, void*) {
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  for (int i = 0; i < library->dlpi_phnum; ++i) {
    const auto& segment = library->dlpi_phdr[i];
    if (segment.p_type != PT_LOAD || (segment.p_flags & PF_W) != 0) continue;
    const std::uintptr_t begin = (library->dlpi_addr + segment.p_vaddr) / page * page,
                         end = library->dlpi_addr + segment.p_vaddr + segment.p_memsz;
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_POPULATE_READ);  // Linux 5.14; an older one does nothing
  }
  return 0;
}

}  // namespace

void make_code_resident() { dl_iterate_phdr(make_resident, nullptr); }

std::size_t memory_peak() { return status_bytes("VmHWM:"); }

std::size_t memory_now() { return status_bytes("VmRSS:"); }

bool reset_memory_peak() {
  std::ofstream references("/proc/self/clear_refs");
  references << "5" << std::flush;  // proc(5): resets the peak resident set size
  return static_cast<bool>(references);
}

}  // namespace geodrome
