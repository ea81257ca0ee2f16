// SPDX-License-Identifier: MIT
#pragma once

#include <immintrin.h>

#include "plugins/common/exact/register.hpp"

namespace geodrome {

/// Eight lanes as bits: such registers compare into masks of their own.
struct Mask8 {
  __mmask8 bits = 0;

  friend Mask8 operator&(Mask8 a, Mask8 b) { return {static_cast<__mmask8>(a.bits & b.bits)}; }
  friend Mask8 operator|(Mask8 a, Mask8 b) { return {static_cast<__mmask8>(a.bits | b.bits)}; }
  friend Mask8 operator~(Mask8 a) { return {static_cast<__mmask8>(~a.bits)}; }
  Mask8& operator|=(Mask8 other) { return *this = *this | other; }
};

/// A register of eight doubles, for processors with AVX-512. Written with intrinsics: from vector types, GCC 12 makes
/// masks and roots one lane at a time.
template <>
struct Register<8> {
  using Mask = Mask8;
  __m512d v = _mm512_setzero_pd();

  Register() = default;
  Register(__m512d value) : v(value) {}
  Register(double value) : v(_mm512_set1_pd(value)) {}
  explicit Register(const double* p) : v(_mm512_loadu_pd(p)) {}
  void store(double* p) const { _mm512_storeu_pd(p, v); }

  friend Register operator+(Register a, Register b) { return a.v + b.v; }
  friend Register operator-(Register a, Register b) { return a.v - b.v; }
  friend Register operator-(Register a) { return -a.v; }
  friend Register operator*(Register a, Register b) { return a.v * b.v; }
  friend Register operator/(Register a, Register b) { return a.v / b.v; }
  friend Mask operator<(Register a, Register b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ)}; }
  friend Mask operator>(Register a, Register b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_GT_OQ)}; }
  friend Mask operator<=(Register a, Register b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LE_OQ)}; }
  friend Mask operator>=(Register a, Register b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_GE_OQ)}; }
  friend Mask operator==(Register a, Register b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_EQ_OQ)}; }
  friend Register select(Mask mask, Register yes, Register no) { return _mm512_mask_blend_pd(mask.bits, no.v, yes.v); }
  friend Register least(Register a, Register b) { return _mm512_min_pd(a.v, b.v); }  // the second of a NaN and another
  friend Register most(Register a, Register b) { return _mm512_max_pd(a.v, b.v); }
  friend Register size(Register a) { return _mm512_abs_pd(a.v); }
  friend Register root(Register a) { return _mm512_sqrt_pd(a.v); }
  friend Register next_lanes(Register a, Register b) { return shifted<1>(a, b); }
  friend Register lanes_before(Register a, Register b) { return shifted<7>(a, b); }

  static Register count_from(double first) { return _mm512_set1_pd(first) + _mm512_set_pd(7, 6, 5, 4, 3, 2, 1, 0); }
  static unsigned bits(Mask mask) { return mask.bits; }
  static bool any(Mask mask) { return mask.bits != 0; }

 private:
  template <int By>
  static Register shifted(Register a, Register b) {
    return _mm512_castsi512_pd(_mm512_alignr_epi64(_mm512_castpd_si512(b.v), _mm512_castpd_si512(a.v), By));
  }
};

}  // namespace geodrome
