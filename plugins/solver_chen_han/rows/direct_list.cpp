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
      group_size_(static_cast<std::uint16_t>(1 + directed_ / (Onward::most_groups + 1))),
      half_turn_(half_turn),
      closed_(closed) {
  for (std::size_t i = 0; i < paths.size(); ++i) {
    paths_[i] = {paths[i].length, paths[i].target, {}};
    arrivals_[i] = paths[i].arrival;
    if (i >= any) exits_[i - any] = paths[i].exit;
  }
  groups_ = static_cast<std::uint16_t>((directed_ + group_size_ - 1) / group_size_);
}

Index DirectList::first_from(int code) const {
  const DirectionCode* const begin = exits_.get();
  return static_cast<Index>(std::lower_bound(begin, begin + directed_, code) - begin);
}

/// The groups that hold `count` directed paths from `first` on.
Onward DirectList::grouped(Index first, Index count) const {
  if (count == 0 && any_ == 0) return {};
  if (count == 0) return {0, 0};
  const Index before_end = std::min(count, directed_ - first), first_group = first / group_size_;
  Index groups = (first + before_end - 1) / group_size_ + 1 - first_group;
  if (before_end < count) groups += (count - before_end - 1) / group_size_ + 1;
  return {static_cast<std::uint16_t>(first_group), static_cast<std::uint16_t>(std::min<Index>(groups, groups_))};
}

std::array<std::span<const DirectPath>, 2> DirectList::directed(Onward onward) const {
  const std::span<const DirectPath> all = directed();
  const std::size_t first = std::size_t{onward.first} * group_size_;
  const std::size_t before_end = std::min<std::size_t>(onward.count, groups_ - onward.first);
  const std::size_t after_end = onward.count - before_end;
  return {all.subspan(first, std::min(before_end * group_size_, all.size() - first)),
          all.first(after_end * group_size_)};
}

Onward DirectList::onward(DirectionCode arrival) const {
  if (arrival == ends_here) return {};
  if (arrival == to_all_sides || half_turn_ == 0) return grouped(0, directed_);
  const int low = arrival + half_turn_, high = arrival - half_turn_ + 1;
  const auto between = [&](int from, int to) {
    const Index first = first_from(from), last = first_from(to);
    return grouped(first, last > first ? last - first : 0);
  };
  if (closed_ && low >= full_angle) return between(low - full_angle, high);
  if (closed_ && high <= 0) return between(low, high + full_angle);
  const Index first = first_from(low);
  return grouped(first == directed_ ? 0 : first, directed_ - first + first_from(high));
}

void DirectList::complete(const std::vector<DirectList>& lists) {
  for (std::size_t i = 0; i < any_ + directed_; ++i) paths_[i].onward = lists[paths_[i].target].onward(arrivals_[i]);
  arrivals_.reset();
}

}  // namespace geodrome::chen_han
