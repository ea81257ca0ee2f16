// SPDX-License-Identifier: MIT
#pragma once

namespace geodrome {

// Compiled for processors that not everybody has as well, as bisector.hpp is.

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

/// A register of N doubles, as a number for formulas.
template <int N>
struct Register {
  using Double = typename VectorType<N>::Double;
  using Mask = typename VectorType<N>::Mask;
  Double v{};

  Register() = default;
  Register(Double value) : v(value) {}
  Register(double value) : v(value - Double{}) {}
  explicit Register(const double* p) { __builtin_memcpy(&v, p, sizeof v); }
  void store(double* p) const { __builtin_memcpy(p, &v, sizeof v); }

  friend Register operator+(Register a, Register b) { return a.v + b.v; }
  friend Register operator-(Register a, Register b) { return a.v - b.v; }
  friend Register operator-(Register a) { return -a.v; }
  friend Register operator*(Register a, Register b) { return a.v * b.v; }
  friend Register operator/(Register a, Register b) { return a.v / b.v; }
  friend Mask operator<(Register a, Register b) { return a.v < b.v; }
  friend Mask operator>(Register a, Register b) { return a.v > b.v; }
  friend Mask operator<=(Register a, Register b) { return a.v <= b.v; }
  friend Mask operator>=(Register a, Register b) { return a.v >= b.v; }
  friend Mask operator==(Register a, Register b) { return a.v == b.v; }
  /// Chooses lane by lane. Precondition: all bits of a lane of the mask are equal.
  friend Register select(Mask mask, Register yes, Register no) {
#ifdef __AVX__
    if constexpr (N == 4) return __builtin_ia32_blendvpd256(no.v, yes.v, (Double)mask);
    if constexpr (N == 2) return __builtin_ia32_blendvpd(no.v, yes.v, (Double)mask);
#endif
    return (Double)((mask & (Mask)yes.v) | (~mask & (Mask)no.v));
  }
  friend Register least(Register a, Register b) { return a.v < b.v ? a.v : b.v; }
  friend Register most(Register a, Register b) { return a.v > b.v ? a.v : b.v; }
  friend Register size(Register a) { return most(a, -a); }
  friend Register root(Register a) {
    Double r;
    for (int k = 0; k < N; ++k) r[k] = __builtin_sqrt(a.v[k]);
    return r;
  }
  static Register count_from(double first) {
    Double r;
    for (int k = 0; k < N; ++k) r[k] = first + k;
    return r;
  }
  double sum() const {
    double all = 0;
    for (int k = 0; k < N; ++k) all += v[k];
    return all;
  }
  /// Returns the lanes of a mask as bits, lane 0 lowest.
  static unsigned bits(Mask mask) {
#ifdef __AVX__
    if constexpr (N == 4) return static_cast<unsigned>(__builtin_ia32_movmskpd256((Double)mask));
#endif
#ifdef __SSE2__
    if constexpr (N == 2) return static_cast<unsigned>(__builtin_ia32_movmskpd((Double)mask));
#endif
    unsigned all = 0;
    for (int k = 0; k < N; ++k) all |= static_cast<unsigned>(mask[k] & 1) << k;
    return all;
  }
  static bool any(Mask mask) { return bits(mask) != 0; }
  /// Returns the lanes of a followed by those of b, without the first, and the last lane of a before those of b.
  friend Register next_lanes(Register a, Register b) {
    if constexpr (N == 2)
      return __builtin_shufflevector(a.v, b.v, 1, 2);
    else
      return __builtin_shufflevector(a.v, b.v, 1, 2, 3, 4);
  }
  friend Register lanes_before(Register a, Register b) {
    if constexpr (N == 2)
      return __builtin_shufflevector(a.v, b.v, 1, 2);
    else
      return __builtin_shufflevector(a.v, b.v, 3, 4, 5, 6);
  }
};

}  // namespace geodrome
