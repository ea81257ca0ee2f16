// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/lanes.hpp"

#include "plugins/solver_chen_han/lanes_body.hpp"

namespace geodrome::chen_han {

#ifdef GEODROME_X86_LEVELS
extern const Lanes avx2_lanes;
extern const Lanes avx512_lanes;

bool has_simd(Simd level) {
  if (level == Simd::avx512) return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
  return level == Simd::baseline || __builtin_cpu_supports("avx2");
}

const Lanes& lanes(Simd level) {
  static constexpr Lanes baseline = lanes_of<2>;
  if (level == Simd::avx512) return avx512_lanes;
  return level == Simd::avx2 ? avx2_lanes : baseline;
}
#else
bool has_simd(Simd level) { return level == Simd::baseline; }

const Lanes& lanes(Simd) {
  static constexpr Lanes baseline = lanes_of<2>;
  return baseline;
}
#endif

Simd best_simd() {
  if (has_simd(Simd::avx512)) return Simd::avx512;
  return has_simd(Simd::avx2) ? Simd::avx2 : Simd::baseline;
}

}  // namespace geodrome::chen_han
