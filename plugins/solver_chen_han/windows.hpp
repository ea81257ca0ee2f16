// SPDX-License-Identifier: MIT
#pragma once

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
};

/// Copies `count` windows, from position `from` to position `to`.
inline void copy_windows(const WindowArrays& source, std::size_t from, std::size_t count, WindowArrays target,
                         std::size_t to) {
  const auto copy = [=](const auto* a, auto* b) { std::memmove(b + to, a + from, count * sizeof(*a)); };
  copy(source.x, target.x), copy(source.y, target.y), copy(source.sigma, target.sigma);
  copy(source.low, target.low), copy(source.high, target.high);
  copy(source.origin, target.origin), copy(source.parent, target.parent);
}

/// An ordered list of windows that grows: what one pass over a half-edge works on. Kept from pass to pass. There is
/// always room for one SIMD register more than it holds.
class WindowList {
 public:
  static constexpr std::size_t lanes = 8;

  WindowList() { reserve(64); }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const WindowArrays& arrays() const { return arrays_; }
  std::size_t bytes() const { return capacity_ * WindowArrays::doubles_per_window * sizeof(double); }

  /// Sets the size; windows beyond the old one have any value.
  void resize(std::size_t size) {
    if (size + lanes > capacity_) reserve(2 * size + lanes);
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
    copy_windows(source, 0, count, arrays_, end);
  }
  /// Drops all but the windows [first, last).
  void keep(std::size_t first, std::size_t last) {
    if (first > 0) copy_windows(arrays_, first, last - first, arrays_, 0);
    size_ = last - first;
  }

 private:
  void reserve(std::size_t capacity) {
    auto memory = std::make_unique<double[]>(capacity * WindowArrays::doubles_per_window);
    const WindowArrays bigger(memory.get(), capacity);
    copy_windows(arrays_, 0, size_, bigger, 0);
    memory_ = std::move(memory), arrays_ = bigger, capacity_ = capacity;
  }

  std::unique_ptr<double[]> memory_;
  WindowArrays arrays_{nullptr, 0};
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace geodrome::chen_han
