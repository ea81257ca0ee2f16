// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <type_traits>

#include "plugins/common/exact/ordered_pair.hpp"
#include "plugins/solver_schreiber/generator.hpp"
#include "tests/plugins/common/window_scenes.hpp"

/// The images of both exact solvers, for tests of what they share.
namespace geodrome::chen_han::test {

using schreiber::Generator;
using Images = testing::Types<Window, Generator>;

struct ImageNames {
  template <class Image>
  static std::string GetName(int) {
    return std::is_same_v<Image, Window> ? "Windows" : "Generators";
  }
};

template <class Image>
Image image_of(const Window& w) {
  if constexpr (std::is_same_v<Image, Window>) {
    return w;
  } else {
    Generator g{w.x, w.y, w.sigma, -1, 0, 1, 0, std::numeric_limits<double>::infinity(), w.origin};
    g.set_low(w.low, 0), g.set_high(w.high, 0);
    return g;
  }
}

/// The part of a half-edge of length 1 that its lines cross.
inline Interval interval_of(const Window& w) { return {w.low, w.high}; }
inline Interval interval_of(const Generator& g) { return {g.low(1), g.high(1)}; }

}  // namespace geodrome::chen_han::test
