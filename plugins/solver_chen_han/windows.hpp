// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>

#include "geodrome/geometry.hpp"

namespace geodrome::chen_han {

/// A window: the straight lines from one pseudo-source that cross a half-edge within [low, high] and enter its face. In
/// the frame of the half-edge (origin at its start, face above) the pseudo-source, unfolded, is the image (x, y), y <=
/// 0; a point p that such a line reaches is at distance sigma + |image p|.
struct Window {
  double x, y, sigma, low, high;
  Index origin;  ///< the pseudo-source: a vertex, or `vertex count + i` for source i of the request
  Index parent;  ///< number of the kept window it came from, no_index if it came from its pseudo-source

  /// Length of the way to (px, py), if a line of the window goes there.
  double to(double px, double py) const { return sigma + std::sqrt((px - x) * (px - x) + (py - y) * (py - y)); }
  /// The same for a point of the half-edge.
  double at(double px) const { return to(px, 0); }
};

/// Registers hold at most this many doubles.
inline constexpr std::size_t most_lanes = 4;
/// Loops over windows, and over pairs of neighbours, may read and write up to so many windows beyond the last one.
inline constexpr std::size_t padding = most_lanes - 1;

/// Windows as arrays, one for each member, so that SIMD lanes read them as they are. Does not own its memory.
struct WindowArrays {
  static constexpr std::size_t doubles_per_window = 6;  // two indices share the sixth

  double *x, *y, *sigma, *low, *high;
  Index *origin, *parent;

  WindowArrays(double* memory, std::size_t capacity)
      : x(memory),
        y(memory + capacity),
        sigma(memory + 2 * capacity),
        low(memory + 3 * capacity),
        high(memory + 4 * capacity),
        origin(reinterpret_cast<Index*>(memory + 5 * capacity)),
        parent(origin + capacity) {}

  /// The same windows without the first `count`.
  WindowArrays without(std::size_t count) const {
    WindowArrays rest = *this;
    rest.x += count, rest.y += count, rest.sigma += count, rest.low += count, rest.high += count;
    rest.origin += count, rest.parent += count;
    return rest;
  }

  Window get(std::size_t i) const { return {x[i], y[i], sigma[i], low[i], high[i], origin[i], parent[i]}; }
  void set(std::size_t i, const Window& w) const {
    x[i] = w.x, y[i] = w.y, sigma[i] = w.sigma, low[i] = w.low, high[i] = w.high;
    origin[i] = w.origin, parent[i] = w.parent;
  }
  bool empty(std::size_t i) const { return !(low[i] < high[i]); }
  double at(std::size_t i, double px) const { return to(i, px, 0); }
  double to(std::size_t i, double px, double py) const {
    return sigma[i] + std::sqrt((px - x[i]) * (px - x[i]) + (py - y[i]) * (py - y[i]));
  }

  /// Puts copies of the last window behind it: lanes that nobody asked for then compute with sound numbers.
  void pad(std::size_t count) const {
    const Window last = get(count - 1);
    for (std::size_t i = count; i < count + padding; ++i)
      x[i] = last.x, y[i] = last.y, sigma[i] = last.sigma, low[i] = last.low, high[i] = last.high;
  }
};

/// Copies windows, `most_lanes` at a time; both must be padded. They may overlap if `to` is before `from`.
inline void copy_windows(const WindowArrays& from, std::size_t count, const WindowArrays& to) {
  for (std::size_t i = 0; i < count; i += most_lanes) {
    const auto copy = [i]<class Number>(const Number* source, Number* target) {
      std::array<Number, most_lanes> taken;
      std::memcpy(taken.data(), source + i, sizeof taken);
      std::memcpy(target + i, taken.data(), sizeof taken);
    };
    copy(from.x, to.x), copy(from.y, to.y), copy(from.sigma, to.sigma), copy(from.low, to.low);
    copy(from.high, to.high), copy(from.origin, to.origin), copy(from.parent, to.parent);
  }
}

/// A list of windows that grows; kept from pass to pass.
class WindowList {
 public:
  WindowList() { reserve(64); }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const WindowArrays& arrays() const { return arrays_; }
  std::size_t bytes() const { return capacity_ * WindowArrays::doubles_per_window * sizeof(double); }

  /// Sets the size; windows beyond the old one have any value.
  void resize(std::size_t size) {
    if (size + 2 * most_lanes > capacity_) reserve(2 * (size + most_lanes));
    size_ = size;
  }
  void clear() { size_ = 0; }
  void push(const Window& window) {
    resize(size_ + 1);
    arrays_.set(size_ - 1, window);
  }
  void append(const WindowArrays& source, std::size_t count) {
    const std::size_t end = size_;
    resize(end + count);
    copy_windows(source, count, arrays_.without(end));
  }

 private:
  void reserve(std::size_t capacity) {
    auto memory = std::make_unique<double[]>(capacity * WindowArrays::doubles_per_window);
    const WindowArrays bigger(memory.get(), capacity);
    if (size_ > 0) copy_windows(arrays_, size_, bigger);
    memory_ = std::move(memory), arrays_ = bigger, capacity_ = capacity;
  }

  std::unique_ptr<double[]> memory_;
  WindowArrays arrays_{nullptr, 0};
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace geodrome::chen_han
