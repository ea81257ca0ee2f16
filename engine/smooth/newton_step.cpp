// SPDX-License-Identifier: MIT
#include "engine/smooth/newton_step.hpp"

#include "engine/smooth/piece_length.hpp"

namespace geodrome {

bool NewtonStep::find(std::span<const SmoothPoint> nodes, std::span<double> moves) {
  const std::size_t last = nodes.size() - 1;
  pivot_.resize(last + 1), right_.resize(last + 1), beside_.resize(last + 1);
  moves[0] = moves[last] = 0;
  // A length of a piece knows its two ends alone, so the system is tridiagonal: it is eliminated as it is assembled.
  PieceLength before = moving_length(nodes[0], nodes[1]);
  for (std::size_t i = 1; i < last; ++i) {
    const PieceLength behind = moving_length(nodes[i], nodes[i + 1]);
    pivot_[i] = before.tt + behind.ss, right_[i] = -(before.t + behind.s), beside_[i] = behind.st;
    if (i > 1) {
      const double factor = before.st / pivot_[i - 1];
      pivot_[i] -= factor * before.st, right_[i] -= factor * right_[i - 1];
    }
    if (!(pivot_[i] > 0)) return false;
    before = behind;
  }
  double next = 0;
  for (std::size_t i = last - 1; i > 0; --i)
    moves[i] = next = (right_[i] - (i + 1 < last ? beside_[i] * next : 0)) / pivot_[i];
  return true;
}

}  // namespace geodrome
