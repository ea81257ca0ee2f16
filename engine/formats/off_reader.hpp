// SPDX-License-Identifier: MIT
#pragma once

#include "engine/formats/soup.hpp"

namespace geodrome::input {

/// Reads OFF: a keyword, the numbers of vertices and faces (and edges), then vertices and faces. They may lie on lines
/// in any way, but the colour of a face ends with its line. So the file is first read with a vertex and a face a line;
/// where that leaves numbers over or does not work, as numbers one after the other, which must come out exactly.
/// Rejects what is neither, or both.
Soup read_off(const SourceFile& file);

}  // namespace geodrome::input
