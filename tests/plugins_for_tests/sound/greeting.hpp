// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/shortest_path_solver.hpp"

namespace geodrome::test {

/// An extension for tests: a table of functions that take an object of the plugin.
struct Greeting {
  static constexpr const char* id = "geodrome.test.greeting/1";
  int (*greet)(const ShortestPathSolver& solver, int times) noexcept;
};

}  // namespace geodrome::test
