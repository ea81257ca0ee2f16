// SPDX-License-Identifier: MIT
#pragma once

namespace geodrome {

/// Fetches the cache line at `place`, which will be used soon; nothing happens if there is no such memory. GCC 12 takes
/// a function that only fetches for one without effect, and drops calls of it, so an effect is stated here.
inline void prefetch(const void* place) {
  __builtin_prefetch(place);
  asm volatile("");
}

/// Fetches all lines of an object that lies in two of them at most.
template <class Object>
void prefetch_two_lines(const Object& object) {
  static_assert(sizeof(Object) > 64 && sizeof(Object) <= 128);
  const char* start = reinterpret_cast<const char*>(&object);
  prefetch(start), prefetch(start + 64);
}

}  // namespace geodrome
