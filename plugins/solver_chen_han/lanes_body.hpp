// SPDX-License-Identifier: MIT
#pragma once

#include "plugins/common/exact/bisector.hpp"
#include "plugins/common/exact/register.hpp"
#include "plugins/solver_chen_han/lanes.hpp"

/// The loops of lanes.hpp for registers of N doubles. Included once by each file that is compiled for a level; all is
/// templates on N, so that no function compiled for one processor is linked into the code for another.
namespace geodrome::chen_han {

template <int N>
[[gnu::flatten]] void carry(const WindowArrays& in, std::size_t count, const Turn& turn, const Clip& clip,
                            const WindowArrays& out) {
  using Double = Register<N>;
  const Double zero, limit(turn.limit), low_end(static_cast<double>(clip.low_end)),
      high_begin(static_cast<double>(clip.high_begin));
  for (std::size_t i = 0; i < count; i += N) {
    const TurnedImage<Double> image(turn, Double(in.x() + i), Double(in.y() + i));
    const Double number = Double::count_from(static_cast<double>(static_cast<int>(i)));
    image.x().store(out.x() + i);
    image.y().store(out.y() + i);
    __builtin_memcpy(out.sigma() + i, in.sigma() + i, N * sizeof(double));
    __builtin_memcpy(out.names() + i, in.names() + i, N * sizeof(double));
    select(number < low_end, zero, image.low(Double(in.low() + i))).store(out.low() + i);
    select(number >= high_begin, limit, image.high(Double(in.high() + i))).store(out.high() + i);
  }
}

/// N windows in registers.
template <int N>
struct Lane {
  using Double = Register<N>;
  Double x, y, sigma, low, high;

  Lane(const WindowArrays& w, std::size_t i)
      : x(w.x() + i), y(w.y() + i), sigma(w.sigma() + i), low(w.low() + i), high(w.high() + i) {}
  /// The neighbours on the right of the windows of `a`, which those of `b` follow.
  Lane(const Lane& a, const Lane& b)
      : x(next_lanes(a.x, b.x)),
        y(next_lanes(a.y, b.y)),
        sigma(next_lanes(a.sigma, b.sigma)),
        low(next_lanes(a.low, b.low)),
        high(next_lanes(a.high, b.high)) {}
  Double at(const Double& place) const { return sigma + root((place - x) * (place - x) + y * y); }
};

/// Pairs of overlapping neighbours, cut: the left ones end at `left_high`, the right ones begin at `right_low`.
/// `unsure` where the rules of lanes.hpp do not tell.
template <int N>
struct PairCut {
  using Double = Register<N>;
  Double left_high, right_low;
  typename Double::Mask unsure;

  PairCut(const Lane<N>& a, const Lane<N>& b, typename Double::Mask is_pair) {
    const Double low = most(a.low, b.low), high = least(a.high, b.high), share(equal_share);
    // The formula takes heights above the images; it has their squares and products only.
    const Double x = most(least(bisector_place(a.x, a.y, a.sigma, b.x, b.y, b.sigma), high), low);
    const Double distance = a.at(x), gap = distance - b.at(x), noise = share * distance;
    const auto overlap = (low < high) & is_pair;
    const auto equal = overlap & (size(gap) <= noise) & is_clear(a, b, low, high);
    const auto first_wins = overlap & (x == high) & (gap < -noise);
    const auto second_wins = overlap & (x == low) & (gap > noise);
    left_high = select(equal, x, select(second_wins, low, a.high));
    right_low = select(equal, x, select(first_wins, high, b.low));
    unsure = (a.high > b.low) & is_pair & ~(equal | first_wins | second_wins);
  }

 private:
  /// Where one interval ends inside the other, the whole rest of that is lost at a cut. So rounding must not be what
  /// makes the one inside nearer.
  static auto is_clear(const Lane<N>& a, const Lane<N>& b, const Double& low, const Double& high) {
    const auto right_inside = b.high < a.high, left_inside = b.low < a.low;
    const Double end = select(right_inside, high, low), distance = a.at(end), gap = distance - b.at(end);
    const auto leads = select(right_inside, gap, -gap) > Double(equal_share) * distance;
    return ~(right_inside | left_inside) | (leads & ~(right_inside & left_inside));
  }
};

template <int N>
[[gnu::flatten]] Trimmed cut(const WindowArrays& w, std::size_t count) {
  using Double = Register<N>;
  if (count == 1) return {false, w.empty(0)};
  const Double last(static_cast<double>(static_cast<int>(count - 1)));
  Double number = Double::count_from(0), right_low(w.low()[0]);
  typename Double::Mask unsure{}, empty{};
  Lane<N> present(w, 0);
  for (std::size_t i = 0; i < count; i += N, number = number + Double(static_cast<double>(N))) {
    const Lane<N> following(w, i + N);
    const auto is_window = number <= last;
    const PairCut<N> pairs(present, Lane<N>(present, following), number < last);
    const Double low = lanes_before(right_low, pairs.right_low), high = pairs.left_high;
    low.store(w.low() + i), high.store(w.high() + i);
    unsure |= pairs.unsure;
    empty |= ~(low < high) & is_window;
    right_low = pairs.right_low, present = following;
  }
  return {Double::any(unsure), Double::any(empty)};
}

/// Parts up to 64 windows, as bits: those with lines to the right must be the last ones, those with lines to the left
/// the first ones.
template <int N>
Parting part_some(const WindowArrays& w, std::size_t count, double x, double y) {
  using Double = Register<N>;
  const Double zero;
  unsigned long long right = 0, left = 0;
  for (std::size_t i = 0; i < count; i += N) {
    const Double ix(w.x() + i), iy(w.y() + i);
    const auto is_right = side_of_line(ix, iy, Double(w.high() + i), x, y) > zero;
    const auto is_left = side_of_line(ix, iy, Double(w.low() + i), x, y) < zero;
    right |= static_cast<unsigned long long>(Double::bits(is_right)) << i;
    left |= static_cast<unsigned long long>(Double::bits(is_left)) << i;
  }
  const unsigned long long all = ~0ULL >> (64 - count), no_right = all & ~right;
  left &= all;
  const bool in_order = ((no_right & (no_right + 1)) | (left & (left + 1))) == 0;
  // In order, these are runs of ones from bit 0: their lengths.
  const auto length = [](unsigned long long run) { return run == ~0ULL ? 64 : __builtin_ctzll(~run); };
  return {static_cast<std::size_t>(length(no_right)), static_cast<std::size_t>(length(left)), in_order};
}

template <int N>
[[gnu::flatten]] Parting part(const WindowArrays& w, std::size_t count, double x, double y) {
  if (count <= 64) return part_some<N>(w, count, x, y);
  Parting parting{0, 0, true};
  for (std::size_t base = 0; base < count; base += 64) {
    const std::size_t size = count - base < 64 ? count - base : 64;
    const Parting some = part_some<N>(w.without(base), size, x, y);
    parting.in_order = parting.in_order && some.in_order && (some.right_begin == 0 || parting.right_begin == base) &&
                       (some.left_end == 0 || parting.left_end == base);
    parting.right_begin += some.right_begin, parting.left_end += some.left_end;
  }
  return parting;
}

template <int N>
constexpr Lanes lanes_of{&carry<N>, &cut<N>, &part<N>};

}  // namespace geodrome::chen_han
