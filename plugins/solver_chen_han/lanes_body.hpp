// SPDX-License-Identifier: MIT
#pragma once

#include "plugins/common/exact/bisector.hpp"
#include "plugins/common/exact/register.hpp"
#include "plugins/solver_chen_han/lanes.hpp"

/// The loops of lanes.hpp for registers of N doubles. Included once by each file that is compiled for a level; all is
/// templates on N, so that no function compiled for one processor is linked into the code for another.
namespace geodrome::chen_han {

template <int N>
void carry(const WindowArrays& in, std::size_t count, const Turn& turn, const WindowArrays& out) {
  using Double = Register<N>;
  for (std::size_t i = 0; i < count; i += N) {
    const TurnedImage<Double> image(turn, Double(in.x + i), Double(in.y + i));
    image.x().store(out.x + i);
    image.y().store(out.y + i);
    __builtin_memcpy(out.sigma + i, in.sigma + i, N * sizeof(double));
    __builtin_memcpy(out.origin + i, in.origin + i, N * sizeof(Index));
    __builtin_memcpy(out.parent + i, in.parent + i, N * sizeof(Index));
    image.low(Double(in.low + i)).store(out.low + i);
    image.high(Double(in.high + i)).store(out.high + i);
  }
}

template <int N>
bool cut(const WindowArrays& w, std::size_t count, double* cuts) {
  using Double = Register<N>;
  const Double zero, none(std::numeric_limits<double>::quiet_NaN()), share(equal_share);
  typename Double::Mask failed{};
  for (std::size_t i = 0; i + 1 < count; i += N) {
    const Double low_1(w.low + i), low_2(w.low + i + 1), high_1(w.high + i), high_2(w.high + i + 1);
    const Double low = most(low_1, low_2), high = least(high_1, high_2);
    const Double x1(w.x + i), x2(w.x + i + 1), h1 = -Double(w.y + i), h2 = -Double(w.y + i + 1);
    const Double s1(w.sigma + i), s2(w.sigma + i + 1);
    const Double x = most(least(bisector_place(x1, h1, s1, x2, h2, s2), high), low);
    const Double d1 = s1 + root((x - x1) * (x - x1) + h1 * h1), d2 = s2 + root((x - x2) * (x - x2) + h2 * h2);
    const Double gap = d1 - d2, noise = share * d1;
    const auto equal = (gap <= noise) & (gap >= -noise);
    const auto first_wins = (x == high_1) & (gap < zero), second_wins = (x == low_2) & (gap > zero);
    const auto in_turn = (low < high) & (low_1 <= low_2) & (high_1 <= high_2), apart = high_1 <= low_2;
    const auto sound = (equal | first_wins | second_wins) & in_turn;
    select(sound & ~apart, x, none).store(cuts + i);
    failed |= ~(apart | sound) & (Double::count_from(static_cast<double>(i + 1)) < Double(static_cast<double>(count)));
  }
  return Double::any(failed);
}

/// Those of n windows are the last (first) of a list whose numbers have the largest (smallest) sum that n numbers can
/// have: one loop, and no branch that depends on the list.
template <int N>
Parting part(const WindowArrays& w, std::size_t count, double x, double y) {
  using Double = Register<N>;
  const Double zero, one(1.0), last(static_cast<double>(count));
  Double rights, right_numbers, lefts, left_numbers, number = Double::count_from(0);
  for (std::size_t i = 0; i < count; i += N, number = number + Double(static_cast<double>(N))) {
    const Double ix(w.x + i), iy(w.y + i);
    const auto right = (side_of_line(ix, iy, Double(w.high + i), x, y) > zero) & (number < last);
    const auto left = (side_of_line(ix, iy, Double(w.low + i), x, y) < zero) & (number < last);
    rights = rights + select(right, one, zero), right_numbers = right_numbers + select(right, number, zero);
    lefts = lefts + select(left, one, zero), left_numbers = left_numbers + select(left, number, zero);
  }
  const double right = rights.sum(), left = lefts.sum(), all = static_cast<double>(count);
  const bool in_order =
      2 * right_numbers.sum() == right * (2 * all - right - 1) && 2 * left_numbers.sum() == left * (left - 1);
  return {count - static_cast<std::size_t>(right), static_cast<std::size_t>(left), in_order};
}

template <int N>
constexpr Lanes lanes_of{&carry<N>, &cut<N>, &part<N>};

}  // namespace geodrome::chen_han
