// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/formats/soup.hpp"

namespace geodrome::input {

/// Turns a triangle strip of a PLY file (element 'tristrips') into faces: each vertex after the second of a run makes
/// one with the two before it, every second one turned round, and -1 ends the run. Source: the models of the Stanford
/// archive.
class StripReader {
 public:
  /// `strip`: its number, for messages.
  StripReader(const SourceFile& file, std::uint64_t strip, std::uint64_t vertex_count, Soup& soup)
      : file_(file), strip_(strip), vertex_count_(vertex_count), soup_(soup) {}

  /// Rejects what is neither -1 nor one of the vertices.
  void add(long long index);
  /// Rejects a run of one or two vertices.
  void end_run();

 private:
  const SourceFile& file_;
  const std::uint64_t strip_, vertex_count_;
  Soup& soup_;
  Index before_[2] = {};
  std::size_t run_ = 0;  // vertices of this run
};

}  // namespace geodrome::input
