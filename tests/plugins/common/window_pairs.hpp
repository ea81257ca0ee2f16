// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "tests/plugins/common/window_scenes.hpp"

namespace geodrome::chen_han::test {

/// Calls `visit(scene, first, second, random)` with pairs of windows whose lines entered the face below in that order,
/// of 4000 random scenes. Ends with the first scene that fails.
template <class Visit>
void for_each_pair(Visit&& visit) {
  constexpr std::uint64_t scenes = 4000;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Scene scene = random_scene(random, 1 + seed % 4);
    for (std::size_t i = 0; i < scene.windows.size(); ++i)
      for (std::size_t j = i + 1; j < scene.windows.size(); ++j)
        if (scene.windows[i].window.low < scene.windows[i].window.high &&
            scene.windows[j].window.low < scene.windows[j].window.high)
          visit(scene, scene.windows[i], scene.windows[j], random);
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace geodrome::chen_han::test
