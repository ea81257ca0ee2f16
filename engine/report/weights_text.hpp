// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>

#include "engine/formats/text_stream.hpp"
#include "geodrome/engine/input.hpp"

namespace geodrome {

/// Range and origin of the weights for people: "0.5 to 4, from property:cost". Precondition: there are some.
inline std::string weights_text(const Input& input) {
  const auto [smallest, largest] = std::ranges::minmax(input.weights);
  TextOutput text;
  text.precision(4);
  text << smallest << " to " << largest << ", from " << input.weights_from;
  return text.str();
}

}  // namespace geodrome
