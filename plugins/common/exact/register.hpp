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
  friend Register select(Mask mask, Register yes, Register no) { return mask ? yes.v : no.v; }
  friend Register least(Register a, Register b) { return a.v < b.v ? a.v : b.v; }
  friend Register most(Register a, Register b) { return a.v > b.v ? a.v : b.v; }
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
  static bool any(Mask mask) {
    long long all = 0;
    for (int k = 0; k < N; ++k) all |= mask[k];
    return all != 0;
  }
};

}  // namespace geodrome
