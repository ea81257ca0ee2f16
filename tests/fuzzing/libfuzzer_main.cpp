// SPDX-License-Identifier: MIT
// fuzz_reader --target=NAME [what libFuzzer takes]: a broken promise is an exception that nobody catches, which
// libFuzzer takes for a crash.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iostream>

#include "tests/fuzzing/target.hpp"

namespace {

const geodrome::fuzzing::Target* chosen = nullptr;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  constexpr std::string_view flag = "--target=";  // libFuzzer passes over flags with two dashes
  std::string names;
  for (const auto& target : geodrome::fuzzing::targets()) {
    names += " " + std::string(target.name);
    for (int i = 1; i < *argc; ++i)
      if ((*argv)[i] == std::string(flag) + std::string(target.name)) chosen = &target;
  }
  if (chosen) return 0;
  std::cerr << "fuzz_reader: write --target=NAME, one of" << names << "\n";
  std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  chosen->check({reinterpret_cast<const char*>(data), size});
  return 0;
}
