// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/rows/direct_list.hpp"

#include <algorithm>

namespace geodrome::chen_han {

DirectList::DirectList(std::span<const FoundPath> paths, std::size_t any, DirectionCode half_turn, bool closed)
    : paths_(std::make_unique_for_overwrite<DirectPath[]>(paths.size())),
      exits_(std::make_unique_for_overwrite<DirectionCode[]>(paths.size() - any)),
      arrivals_(std::make_unique_for_overwrite<DirectionCode[]>(paths.size())),
      any_(static_cast<Index>(any)),
      directed_(static_cast<Index>(paths.size() - any)),
      half_turn_(half_turn),
      closed_(closed) {
  for (std::size_t i = 0; i < paths.size(); ++i) {
    paths_[i] = {paths[i].length, paths[i].target, {}};
    arrivals_[i] = paths[i].arrival;
    if (i >= any) exits_[i - any] = paths[i].exit;
  }
}

Index DirectList::first_from(int code) const {
  const DirectionCode* const begin = exits_.get();
  return static_cast<Index>(std::lower_bound(begin, begin + directed_, code) - begin);
}

Onward DirectList::onward(DirectionCode arrival) const {
  if (arrival == ends_here) return {};
  const auto paths = [this](Index first, Index count) -> Onward {
    if (count == 0 && any_ == 0) return {};
    return {static_cast<std::uint16_t>(count == 0 ? 0 : first), static_cast<std::uint16_t>(count)};
  };
  if (arrival == to_all_sides || half_turn_ == 0) return paths(0, directed_);
  const int low = arrival + half_turn_, high = arrival - half_turn_ + 1;
  const auto between = [&](int from, int to) {
    const Index first = first_from(from), last = first_from(to);
    return paths(first, last > first ? last - first : 0);
  };
  if (closed_ && low >= full_angle) return between(low - full_angle, high);
  if (closed_ && high <= 0) return between(low, high + full_angle);
  const Index first = first_from(low);
  return paths(first == directed_ ? 0 : first, directed_ - first + first_from(high));
}

void DirectList::complete(const std::vector<DirectList>& lists) {
  for (std::size_t i = 0; i < any_ + directed_; ++i) paths_[i].onward = lists[paths_[i].target].onward(arrivals_[i]);
  arrivals_.reset();
}

}  // namespace geodrome::chen_han
