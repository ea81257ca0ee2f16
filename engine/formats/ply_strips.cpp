// SPDX-License-Identifier: MIT
#include "engine/formats/ply_strips.hpp"

namespace geodrome::input {

namespace {

constexpr long long restart = -1;

}  // namespace

void StripReader::add(long long index) {
  if (index == restart) return end_run();
  if (index < 0 || static_cast<unsigned long long>(index) >= vertex_count_)
    reject(file_, InputFault::index,
           "triangle strip " + std::to_string(strip_) + " names vertex " + std::to_string(index) + ", but there are " +
               std::to_string(vertex_count_) + " vertices, counted from 0");
  const auto vertex = static_cast<Index>(index);
  if (run_ >= 2) {
    const bool turned = run_ % 2 == 1;
    soup_.corners.insert(soup_.corners.end(), {before_[turned ? 1 : 0], before_[turned ? 0 : 1], vertex});
    soup_.face_end.push_back(soup_.corners.size());
  }
  before_[0] = before_[1], before_[1] = vertex;
  ++run_;
}

void StripReader::end_run() {
  if (run_ == 1 || run_ == 2)
    reject(file_, InputFault::syntax,
           "triangle strip " + std::to_string(strip_) + " has a run of " + std::to_string(run_) +
               (run_ == 1 ? " vertex" : " vertices") + ", which makes no triangle");
  run_ = 0;
}

}  // namespace geodrome::input
