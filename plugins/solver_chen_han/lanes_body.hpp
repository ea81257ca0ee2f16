// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "solver_chen_han/lanes.hpp"

/// The loops of lanes.hpp for registers of N doubles. Included once by each file that is compiled for a level; all is
/// templates on N, so that no function compiled for one processor is linked into the code for another.
namespace geodrome::chen_han {

template <int N>
struct VectorType;
template <>
struct VectorType<2> {
  typedef double Double __attribute__((vector_size(16)));
  typedef long long Mask __attribute__((vector_size(16)));
};
template <>
struct VectorType<4> {
  typedef double Double __attribute__((vector_size(32)));
  typedef long long Mask __attribute__((vector_size(32)));
};
template <>
struct VectorType<8> {
  typedef double Double __attribute__((vector_size(64)));
  typedef long long Mask __attribute__((vector_size(64)));
};

template <int N>
struct Register {
  using Double = typename VectorType<N>::Double;
  using Mask = typename VectorType<N>::Mask;

  static Double load(const double* p) {
    Double v;
    __builtin_memcpy(&v, p, sizeof v);
    return v;
  }
  static void store(double* p, Double v) { __builtin_memcpy(p, &v, sizeof v); }
  static Double all(double v) { return v - Double{}; }
  static Double root(Double v) {
    Double r;
    for (int k = 0; k < N; ++k) r[k] = __builtin_sqrt(v[k]);
    return r;
  }
  static Double least(Double a, Double b) { return a < b ? a : b; }
  static Double most(Double a, Double b) { return a > b ? a : b; }
};

template <int N>
void carry(const WindowArrays& in, std::size_t first, std::size_t count, const Turn& turn, const WindowArrays& out) {
  using R = Register<N>;
  using Double = typename R::Double;
  const Double zero{}, limit = R::all(turn.limit), away = R::all(turn.away);
  for (std::size_t i = 0; i < count; i += N) {
    const Double px = R::load(in.x + first + i) - turn.pivot, py = R::load(in.y + first + i);
    const Double x = turn.cosine * px + turn.sine * py + turn.shift;
    const Double y = R::least(turn.cosine * py - turn.sine * px, zero);
    R::store(out.x + i, x);
    R::store(out.y + i, y);
    // The line from the image through the end (qx, qy) of the window goes on to y = 0.
    const auto onward = [&](const double* end) -> Double {
      const Double p = R::load(end + first + i) - turn.pivot;
      const Double qx = turn.cosine * p + turn.shift, down = turn.sine * p, climb = -down - y;
      const Double met = qx + (qx - x) * down / climb;
      const Double missed = down > zero ? away : qx;
      const Double place = climb > zero ? met : missed;
      return R::most(R::least(place, limit), zero);
    };
    R::store(out.low + i, onward(in.low));
    R::store(out.high + i, onward(in.high));
  }
}

/// The bisector of images 1 and 2 on the edge solves |p - g1| + s1 = |p - g2| + s2 for p = (x1 + t, 0): a quadratic
/// equation in t, of which one root is wanted. With w = g2 - g1, s = s2 - s1, c = w^2 - s^2, h the heights of the edge
/// above the images, beta = w_y h1 - c/2 and Q = sqrt(c (4 h1 h2 + c)) / 2 it is t = (s Q - w_x beta) / (w_x^2 - s^2) =
/// (s^2 h1^2 - beta^2) / (s Q + w_x beta), whichever does not cancel. The result is then checked, so that neither the
/// other root nor rounding can ever cut where the two are not equally far.
template <int N>
bool cut(const WindowArrays& w, std::size_t count, double* cuts) {
  using R = Register<N>;
  using Double = typename R::Double;
  using Mask = typename R::Mask;
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  const Double zero{}, none = R::all(std::numeric_limits<double>::infinity());
  const Double unknown = R::all(std::numeric_limits<double>::quiet_NaN());
  Mask failed{};
  for (std::size_t i = 0; i + 1 < count; i += N) {
    const Double low = R::most(R::load(w.low + i), R::load(w.low + i + 1));
    const Double high = R::least(R::load(w.high + i), R::load(w.high + i + 1));
    const Double x1 = R::load(w.x + i), x2 = R::load(w.x + i + 1);
    const Double h1 = -R::load(w.y + i), h2 = -R::load(w.y + i + 1);
    const Double s1 = R::load(w.sigma + i), s2 = R::load(w.sigma + i + 1);
    const Double wx = x2 - x1, wy = h1 - h2, s = s2 - s1;
    const Double c = wx * wx + wy * wy - s * s, beta = wy * h1 - 0.5 * c;
    const Double sq = 0.5 * s * R::root(R::most(c * (4.0 * h1 * h2 + c), zero)), wb = wx * beta, sh = s * h1;
    const Mask same = (sq * wb) > zero;
    const Double above = same ? (sh - beta) * (sh + beta) : sq - wb;
    const Double below = same ? sq + wb : wx * wx - s * s;
    const Double x = R::most(R::least(x1 + above / below, high), low);
    const Double d1 = s1 + R::root((x - x1) * (x - x1) + h1 * h1), d2 = s2 + R::root((x - x2) * (x - x2) + h2 * h2);
    const Double gap = d1 - d2, noise = rounding * d1;
    const Mask equal = (gap <= noise) & (gap >= -noise);
    const Mask first_wins = (x == R::load(w.high + i)) & (gap < zero);
    const Mask second_wins = (x == R::load(w.low + i + 1)) & (gap > zero);
    const Mask sound = equal | first_wins | second_wins, overlap = low < high, apart = R::load(w.high + i) <= R::load(w.low + i + 1);
    const Double found = (sound & overlap) ? x : unknown;
    R::store(cuts + i, apart ? none : found);
    if (i + N < count) {
      failed |= ~(apart | (sound & overlap));
    } else {
      for (std::size_t k = i; k + 1 < count; ++k) failed[0] |= cuts[k] != cuts[k] ? -1 : 0;
    }
  }
  bool any = false;
  for (int k = 0; k < N; ++k) any |= failed[k] != 0;
  return any;
}

template <int N>
bool parted(const WindowArrays& w, std::size_t count, double x, double y, std::size_t right_begin,
            std::size_t left_end) {
  using R = Register<N>;
  using Double = typename R::Double;
  using Mask = typename R::Mask;
  const Double zero{}, begin = R::all(static_cast<double>(right_begin)), end = R::all(static_cast<double>(left_end));
  const Double last = R::all(static_cast<double>(count));
  Double index;
  for (int k = 0; k < N; ++k) index[k] = k;
  Mask wrong{};
  for (std::size_t i = 0; i < count; i += N, index += static_cast<double>(N)) {
    const Double ix = R::load(w.x + i), iy = R::load(w.y + i);
    const Mask right = side_of_line(ix, iy, R::load(w.high + i), x, y) > zero;
    const Mask left = side_of_line(ix, iy, R::load(w.low + i), x, y) < zero;
    wrong |= ((right ^ (index >= begin)) | (left ^ (index < end))) & (index < last);
  }
  bool any = false;
  for (int k = 0; k < N; ++k) any |= wrong[k] != 0;
  return !any;
}

template <int N>
constexpr Lanes lanes_of{&carry<N>, &cut<N>, &parted<N>};

}  // namespace geodrome::chen_han
