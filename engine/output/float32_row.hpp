// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include "engine/formats/number_text.hpp"
#include "geodrome/errors.hpp"

namespace geodrome {

/// Rounds a row to float32. Throws OptionError where that would turn a finite distance into "unreachable" or into 0;
/// `matrix` is the name of the matrix in the message. Precondition: out.size() == values.size().
inline void round_to_float32(std::span<const double> values, std::span<float> out, std::uint64_t row,
                             const std::string& matrix) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    out[i] = static_cast<float>(values[i]);
    if (std::isfinite(values[i]) != std::isfinite(out[i]) || (values[i] == 0) != (out[i] == 0))
      throw OptionError("the distance " + number_text(values[i]) + " (row " + std::to_string(row) + ", column " +
                            std::to_string(i) + " of " + matrix + ") does not fit into float32",
                        "store float64");
  }
}

}  // namespace geodrome
