// SPDX-License-Identifier: MIT
#include "plugins/solver_merged_windows/merging.hpp"

#include <algorithm>
#include <cmath>

#include "plugins/common/exact/bisector.hpp"

namespace geodrome::merged_windows {
namespace {

/// A merge may take this share of what is left of the slack.
constexpr double share_of_slack = 0.5;
/// Images are at most so many times as far away as the half-edge is long and its points are from the source: beyond,
/// sigma and |image p| cancel.
constexpr double farthest_image = 32;
/// The place where an image that fails lies next, nearer by this factor, and how often it is tried.
constexpr double nearer_image = 0.6;
constexpr int most_tries = 4;
/// What L and U of a merged window may be off by rounding, as a share of L + |image p|.
constexpr double rounding_of_l = 1e-15, rounding_of_u = 1e-14;
/// Two windows have no gap between them up to this share of their half-edge.
constexpr double no_gap = 1e-14;

}  // namespace

void Merging::list_ends(std::span<const Window> windows) {
  ends_.resize(windows.size());
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const Window& w = windows[i];
    const double low = w.low - w.x, high = w.high - w.x, h2 = w.y * w.y;
    const double to_low = std::sqrt(low * low + h2), to_high = std::sqrt(high * high + h2);
    ends_[i] = {w.sigma + to_low, w.sigma + to_high, to_low > 0 ? low / to_low : -1, to_high > 0 ? high / to_high : 1};
  }
}

/// A source inside the face below may be nearer than a corner that would have to be cut.
bool Merging::touch(const Window& left, const Window& right, const Edge& edge) {
  return edge.sine > 0 && !left.from_face_below && !right.from_face_below &&
         std::abs(right.low - left.high) <= no_gap * edge.length;
}

/// Finds the end of the longest group of at most `most` windows from `first` on that become one, `window`; first + 1 if
/// there is none.
std::size_t Merging::group_from(std::span<const Window> windows, std::size_t first, std::size_t most, const Edge& edge,
                                Window& window) {
  std::size_t count = 1;
  while (first + count < windows.size() && count < most && ends_[first + count - 1].joins_next) ++count;
  for (; count > 1; count /= 2) {
    ++counts_.tried;
    if (!merged(windows.subspan(first, count), &ends_[first], edge, window)) continue;
    ++counts_.done;
    break;
  }
  return first + count;
}

/// L of the merged window is that of the old ones at both ends of the group. That leaves one parameter, the distance r
/// of its image from the low end: the smaller r, the more its lines spread and the lower L is in between.
bool Merging::merged(std::span<const Window> windows, const Ends* ends, const Edge& edge, Window& window) const {
  const Ends &first = ends[0], &last = ends[windows.size() - 1];
  const double low = windows.front().low, high = windows.back().high, width = high - low;
  const double rise = last.l_high - first.l_low, spread = width * width - rise * rise;
  if (!(spread > 1e-12 * width * width)) return false;  // lines along the half-edge

  double slack = 0;
  double kinks = 0;  // about what the group costs
  for (std::size_t i = 0; i < windows.size(); ++i) {
    slack = std::max(slack, windows[i].slack);
    if (i == 0) continue;
    const double place = windows[i].low;
    kinks += std::abs(ends[i - 1].slope_high - ends[i].slope_low) * (place - low) * (high - place);
  }
  const double most = delta_ * 0.5 * (first.l_low + last.l_high - width);
  if (!(slack + 0.4 * kinks / width <= slack + share_of_slack * (most - slack))) return false;

  double r = farthest_image * (edge.length + first.l_low);
  const double below_first = rise - first.slope_low * width, above_last = last.slope_high * width - rise;
  if (below_first > 0) r = std::min(r, 0.5 * spread / below_first);
  if (above_last > 0) r = std::min(r, 0.5 * spread / above_last - rise);
  for (int tries = 0; tries < most_tries; ++tries, r *= nearer_image) {
    const double slope = (rise - 0.5 * spread / r) / width;
    if (!(r > 0 && r + rise > 0 && std::abs(slope) < 1)) return false;
    window = windows.front();
    window.high = high;
    window.x = low - r * slope, window.y = -r * std::sqrt(1 - slope * slope), window.sigma = first.l_low - r;
    const Fit fit = settle(windows, ends, edge, window);
    if (fit == Fit::fits) return true;
    if (fit == Fit::costly) return false;
  }
  return false;
}

/// Checks a merged window against the old ones, and gives it its slack: wherever L is changed, U stays what it was at
/// least. L of an old window less L of the merged one is extreme at the ends of a piece and where the line through both
/// images meets the half-edge.
Merging::Fit Merging::settle(std::span<const Window> windows, const Ends* ends, const Edge& edge, Window& merged) const {
  const double low = merged.low, high = merged.high, r = ends[0].l_low - merged.sigma;
  const double size = ends[0].l_low + r, noise = rounding_of_l * size;
  const auto slope_at = [&](double place, double l) { return (place - merged.x) / (l - merged.sigma); };
  double l_low = ends[0].l_low, slope_low = slope_at(low, l_low);
  double slack = 0, most_drop = 0, most_turn = 0, steepest = std::abs(slope_low);
  bool continuous = true;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const Window& old = windows[i];
    const bool is_last = i + 1 == windows.size();
    const double l_high = is_last ? ends[i].l_high : merged.at(old.high);
    const double slope_high = slope_at(old.high, l_high);
    double least = ends[i].l_high - l_high, most = least;
    const auto look_at = [&](double gap) { least = std::min(least, gap), most = std::max(most, gap); };
    look_at(ends[i].l_low - l_low);
    const double turn = old.x + (merged.x - old.x) * (old.y / (old.y - merged.y));
    if (old.low < turn && turn < old.high) look_at(old.at(turn) - merged.at(turn));
    if (least < -noise) return Fit::above;

    slack = std::max(slack, old.slack + std::max(most, 0.0));
    most_drop = std::max(most_drop, most);
    most_turn = std::max({most_turn, ends[i].slope_high - slope_low, slope_low - ends[i].slope_high,
                          slope_high - ends[i].slope_low, ends[i].slope_low - slope_high});
    steepest = std::max({steepest, std::abs(ends[i].slope_low), std::abs(ends[i].slope_high)});
    if (is_last) {
      steepest = std::max(steepest, std::abs(slope_high));
    } else {
      continuous = continuous && std::abs(ends[i + 1].l_low - ends[i].l_high) <= equal_share * size;
      const double next_low = windows[i + 1].low;
      l_low = next_low == old.high ? l_high : merged.at(next_low);
      slope_low = next_low == old.high ? slope_high : slope_at(next_low, l_low);
    }
  }
  slack += rounding_of_u * size;
  double most_slack = 0;
  for (const Window& old : windows) most_slack = std::max(most_slack, old.slack);
  const double allowed = delta_ * 0.5 * (ends[0].l_low + ends[windows.size() - 1].l_high - (high - low));
  if (!(slack <= most_slack + share_of_slack * (allowed - most_slack))) return Fit::costly;
  const double room = edge.sine * (1 - steepest * steepest);
  if (!(continuous && most_turn <= room) && !(most_drop <= room * std::min(low, edge.length - high))) return Fit::costly;
  merged.slack = slack;
  return Fit::fits;
}

}  // namespace geodrome::merged_windows
