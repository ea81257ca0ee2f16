// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
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
inline constexpr std::size_t most_lanes = 8;

/// Windows as arrays, one for each member, so that SIMD lanes read them as they are: array k begins k `stride`s behind
/// the first. Does not own its memory.
class WindowArrays {
 public:
  static constexpr std::size_t doubles_per_window = 6;  // the names share the sixth

  /// The names of a window, which no formula needs.
  struct Names {
    Index origin, parent;
  };
  static_assert(sizeof(Names) == sizeof(double));

  WindowArrays(double* memory, std::size_t stride) : memory_(memory), stride_(stride) {}

  double* x() const { return memory_; }
  double* y() const { return memory_ + stride_; }
  double* sigma() const { return memory_ + 2 * stride_; }
  double* low() const { return memory_ + 3 * stride_; }
  double* high() const { return memory_ + 4 * stride_; }
  Names* names() const { return reinterpret_cast<Names*>(memory_ + 5 * stride_); }

  /// The same windows without the first `count`.
  WindowArrays without(std::size_t count) const { return {memory_ + count, stride_}; }

  Window get(std::size_t i) const {
    return {x()[i], y()[i], sigma()[i], low()[i], high()[i], names()[i].origin, names()[i].parent};
  }
  void set(std::size_t i, const Window& w) const {
    x()[i] = w.x, y()[i] = w.y, sigma()[i] = w.sigma, low()[i] = w.low, high()[i] = w.high;
    names()[i] = {w.origin, w.parent};
  }
  bool empty(std::size_t i) const { return !(low()[i] < high()[i]); }
  double at(std::size_t i, double px) const { return to(i, px, 0); }
  double to(std::size_t i, double px, double py) const {
    const double dx = px - x()[i], dy = py - y()[i];
    return sigma()[i] + std::sqrt(dx * dx + dy * dy);
  }

 private:
  double* memory_;
  std::size_t stride_;
};

/// Windows where they are.
struct Span {
  WindowArrays windows;
  std::size_t count;
};

/// Copies are made of so many windows at a time.
inline constexpr std::size_t copied_at_once = 4;
inline std::size_t room_for_copy(std::size_t count) {
  return (count + copied_at_once - 1) / copied_at_once * copied_at_once;
}

/// Copies windows; `to` has `room_for_copy(count)`. They may overlap if `to` is before `from`.
inline void copy_windows(const WindowArrays& from, std::size_t count, const WindowArrays& to) {
  for (std::size_t i = 0; i < count; i += copied_at_once) {
    const auto copy = [i]<class Member>(const Member* source, Member* target) {
      std::array<Member, copied_at_once> taken;
      std::memcpy(taken.data(), source + i, sizeof taken);
      std::memcpy(target + i, taken.data(), sizeof taken);
    };
    copy(from.x(), to.x()), copy(from.y(), to.y()), copy(from.sigma(), to.sigma()), copy(from.low(), to.low());
    copy(from.high(), to.high()), copy(from.names(), to.names());
  }
}

/// A list of windows that grows; kept from pass to pass.
class WindowList {
 public:
  WindowList() { grow(64); }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const WindowArrays& arrays() const { return arrays_; }
  std::size_t bytes() const { return capacity_ * WindowArrays::doubles_per_window * sizeof(double); }

  /// Sets the size; windows beyond the old one have any value. There is room for `2 * most_lanes` more.
  void resize(std::size_t size) {
    if (size + 2 * most_lanes > capacity_) grow(2 * (size + most_lanes));
    size_ = size;
  }
  void clear() { size_ = 0; }
  /// Becomes a copy of a list that is elsewhere, with room for `room` windows.
  void assign(const Span& list, std::size_t room = 0) {
    size_ = 0;
    resize(std::max(room, list.count));
    size_ = list.count;
    copy_windows(list.windows, list.count, arrays_);
  }
  Span span() const { return {arrays_, size_}; }
  void push(const Window& window) {
    resize(size_ + 1);
    arrays_.set(size_ - 1, window);
  }

 private:
  void grow(std::size_t capacity) {
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
