// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

namespace geodrome::fuzzing {

/// An input that broke a promise once.
struct Found {
  std::string_view target, what, input;
};

std::span<const Found> found_inputs();

}  // namespace geodrome::fuzzing
