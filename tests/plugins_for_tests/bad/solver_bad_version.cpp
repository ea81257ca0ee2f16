// SPDX-License-Identifier: MIT
// Built for an interface of tomorrow: what follows the first three members is not where this host would look for it.
#include "geodrome/abi.hpp"

namespace {
struct FutureDescriptor {
  std::uint32_t size = 4000, interface_version = 4711;
  const char* build_tag = geodrome::build_tag;
  const void* elsewhere[20] = {};
};
}  // namespace

extern "C" __attribute__((visibility("default"))) const void* geodrome_plugin() noexcept {
  static const FutureDescriptor future;
  return &future;
}
