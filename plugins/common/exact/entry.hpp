// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace geodrome {

/// The entry of a wavefront: where its rays entered the face below a half-edge. In this order such rays cross the
/// half-edge without crossing each other.
enum class Entry : std::uint8_t {
  left,   ///< through the edge at the start of the half-edge
  apex,   ///< from the vertex opposite: a pseudo-source
  right,  ///< through the edge at the end of the half-edge
  loose   ///< in no order with others: from a source in the face, or across an edge of more than two faces
};

/// Returns the entry as seen from a half-edge that runs the other way.
inline Entry mirrored(Entry entry) {
  if (entry == Entry::left) return Entry::right;
  return entry == Entry::right ? Entry::left : entry;
}

}  // namespace geodrome
