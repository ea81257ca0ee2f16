// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

/// Section 4, Lemma 22: what an approximate solver costs, or saves, in place of an exact one.
///
/// A tight epsilon-sample has n = Theta(epsilon^-2) points. Aleksandrov et al.'s structure takes n^2 / (delta^1.5 q) to
/// build and q for a pair, n^2 q for all pairs, up to logarithms and the genus: least at q = delta^-3/4, n^2 delta^-3/4
/// in total. An exact solver takes n^2 log n.
///
/// Case 2, the quality of Lemmas 20 and 21 is kept: delta must be Theta(epsilon) = n^-1/2, and the total is
/// n^(2 + 3/8) = n^(19/8), the paper's exponent.
///
/// Case 1, the time is kept: a coarser sample of n' points with delta = epsilon(n') and n'^(19/8) = n^2, so that
/// n' = n^(16/19). Its epsilon(n') is n'^-1/2 = epsilon^(16/19), so that distances are too long by O(epsilon^0.842)
/// (Lemma 21) and too short by O(epsilon^0.421) (Lemma 20: the square root). The paper prints 1/1.08 = 0.926 and 0.427;
/// this derivation does not give them.
namespace geodrome::bench {

inline constexpr double case1_points = 16.0 / 19;  ///< n' = n^case1_points
inline constexpr double case1_over = 16.0 / 19;    ///< exponents in epsilon of errors
inline constexpr double case1_under = 8.0 / 19;

/// n' of case 1, rounded.
std::size_t coarser(std::size_t points);

/// The c of epsilon = c n^-1/2 that fits measured ones best: their geometric mean of epsilon n^1/2. Preconditions: not
/// empty, as many of one as of the other, all positive.
double epsilon_constant(std::span<const std::size_t> points, std::span<const double> epsilon);

/// delta = c n^-1/2 of both cases, at most 1.
double delta_of(double constant, std::size_t points);

}  // namespace geodrome::bench
