// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "engine/formats/number_text.hpp"
#include "geodrome/geometry.hpp"

namespace geodrome {

/// Appends a line: `before`, then the coordinates, which read back as the same numbers.
inline void append_point(std::string& text, std::string_view before, const Vec3& p) {
  text += before;
  append_number(text, p.x);
  text += ' ';
  append_number(text, p.y);
  text += ' ';
  append_number(text, p.z);
  text += '\n';
}

/// Appends a line: `before`, then the corners, counted from `base`.
inline void append_face(std::string& text, std::string_view before, const Triangle& triangle, Index base) {
  text += before;
  for (const Index v : triangle) text += ' ' + std::to_string(v + base);
  text += '\n';
}

}  // namespace geodrome
