// SPDX-License-Identifier: MIT
#include "engine/formats/csv.hpp"

#include <charconv>
#include <cmath>

namespace geodrome {

void append_csv_row(std::string& text, std::span<const double> values, ScalarType scalar) {
  char number[csv_bytes_per_entry];
  const char* separator = "";
  for (const double value : values) {
    text += separator;
    separator = ",";
    if (std::isnan(value)) {  // to_chars would show the sign of a NaN, which means nothing
      text += "nan";
      continue;
    }
    const auto [end, error] = scalar == ScalarType::float64
                                  ? std::to_chars(number, std::end(number), value)
                                  : std::to_chars(number, std::end(number), static_cast<float>(value));
    text.append(number, end);
  }
  text += '\n';
}

}  // namespace geodrome
