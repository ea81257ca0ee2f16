// SPDX-License-Identifier: MIT
#include "plugins/solver_merged_windows/merging.hpp"

#include <algorithm>
#include <array>
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

/// Whether a merge, for which the slack has to grow by about `more`, takes no more than it may.
bool pays(double slack, double more, double most_slack) {
  return slack + more <= slack + share_of_slack * (most_slack - slack);
}

}  // namespace

Merging::Seam::Seam(const Pair& pair) {
  const Two place = both(pair.high.v[0], pair.low.v[1]), reach = pair.reach(place);
  l = pair.sigma + reach, slope = (place - pair.x) / reach;
}

Merging::Seam::Seam(const Ends& left, const Ends& right)
    : l(both(left.l_high, right.l_low)), slope(both(left.slope_high, right.slope_low)) {}

/// What the seam costs a group grows with the group, and what a merge may take does not: L at the ends of a group is at
/// most that at the seam and the way along the half-edge.
bool Merging::is_hopeless(const Window& left, const Window& right, double length, const Seam& seam) {
  if (!touch(left, right, length)) return true;
  const double place = right.low, width = right.high - left.low, slack = std::max(left.slack, right.slack);
  const double kink = std::abs(seam.slope.v[0] - seam.slope.v[1]) * (place - left.low) * (right.high - place);
  const double most = delta_ * 0.5 * (seam.l.v[0] + seam.l.v[1]) * (1 + 1e-9);
  if (pays(slack, kink / width, most)) return false;
  ++counts_.tried;
  return true;
}

bool Merging::merge_two(std::array<Window, 2>& windows, const Edge& edge, const Seam& seam) {
  if (!(edge.sine > 0)) return false;
  auto& [left, right] = windows;
  const Pair pair(left, right);
  const Two place = both(left.low, right.high), reach = pair.reach(place);
  const Two l = pair.sigma + reach, slope = (place - pair.x) / reach;
  const std::array<Ends, 2> ends{{{l.v[0], seam.l.v[0], reach.v[0] > 0 ? slope.v[0] : -1, seam.slope.v[0]},
                                  {seam.l.v[1], l.v[1], seam.slope.v[1], reach.v[1] > 0 ? slope.v[1] : 1}}};
  ++counts_.tried;
  Window window;
  if (!merged(windows, ends.data(), edge, window)) return false;
  ++counts_.done;
  window.depth = std::max<std::uint32_t>(left.depth, right.depth) & Window::deepest;
  left = window;
  return true;
}

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
bool Merging::touch(const Window& left, const Window& right, double length) {
  return !left.from_face_below && !right.from_face_below && std::abs(right.low - left.high) <= no_gap * length;
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
    for (const Window& old : windows.subspan(first, count))
      if (old.depth > window.depth) window.depth = old.depth;
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
  if (!pays(slack, kinks / width, most)) return false;

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

/// Notes how one old window differs from the merged one. L of the old less L of the merged one is extreme at the ends
/// of the piece and where the line through both images meets the half-edge; slopes rise along it.
void Merging::compare(const Window& old, const Ends& ends, const Window& merged, const Place& low, const Place& high,
                      Differences& all) {
  double least = ends.l_high - high.l, most = least;
  const auto look_at = [&](double gap) { least = std::min(least, gap), most = std::max(most, gap); };
  look_at(ends.l_low - low.l);
  const double turn = old.x + (merged.x - old.x) * (old.y / (old.y - merged.y));
  if (old.low < turn && turn < old.high) look_at(old.at(turn) - merged.at(turn));
  all.rise = std::max(all.rise, -least);
  all.drop = std::max(all.drop, most);
  all.slack = std::max(all.slack, old.slack + std::max(most, 0.0));
  all.turn = std::max({all.turn, std::abs(ends.slope_high - low.slope), std::abs(high.slope - ends.slope_low)});
  all.steepest = std::max({all.steepest, std::abs(ends.slope_low), std::abs(ends.slope_high)});
}

/// Checks a merged window against the old ones, and gives it its slack.
Merging::Fit Merging::settle(std::span<const Window> windows, const Ends* ends, const Edge& edge,
                             Window& merged) const {
  const auto place_at = [&](double x, double l) { return Place{l, (x - merged.x) / (l - merged.sigma)}; };
  const std::size_t count = windows.size();
  const double size = 2 * ends[0].l_low - merged.sigma;  // L and |image p| at the low end
  Place low = place_at(merged.low, ends[0].l_low);
  Differences all{.steepest = std::abs(low.slope)};
  double old_slack = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Window& old = windows[i];
    const bool is_last = i + 1 == count;
    const Place high = place_at(old.high, is_last ? ends[i].l_high : merged.at(old.high));
    compare(old, ends[i], merged, low, high, all);
    old_slack = std::max(old_slack, old.slack);
    low = high;
    if (is_last) break;
    all.jump = std::max(all.jump, std::abs(ends[i + 1].l_low - ends[i].l_high));
    if (const double next = windows[i + 1].low; next != old.high) low = place_at(next, merged.at(next));
  }
  if (all.rise > rounding_of_l * size) return Fit::above;

  merged.slack = all.slack + rounding_of_u * size;
  const double most_slack = delta_ * 0.5 * (ends[0].l_low + ends[count - 1].l_high - (merged.high - merged.low));
  if (!(merged.slack <= old_slack + share_of_slack * (most_slack - old_slack))) return Fit::costly;
  const double steepest = std::max(all.steepest, std::abs(low.slope));
  const double room = edge.sine * (1 - steepest * steepest);
  const bool gradual = all.jump <= equal_share * size && all.turn <= room;
  const bool small = all.drop <= room * std::min(merged.low, edge.length - merged.high);
  return gradual || small ? Fit::fits : Fit::costly;
}

}  // namespace geodrome::merged_windows
