// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "plugins/solver_chen_han/lanes.hpp"

namespace geodrome::chen_han::test {

inline constexpr Simd levels[] = {Simd::baseline, Simd::avx2, Simd::avx512};

inline std::string name_of(Simd level) {
  return level == Simd::avx512 ? "avx512" : level == Simd::avx2 ? "avx2" : "baseline";
}
inline std::string level_name(const testing::TestParamInfo<Simd>& info) { return name_of(info.param); }

}  // namespace geodrome::chen_han::test
