// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/rows/row_labels.hpp"

#include <algorithm>

#include "plugins/common/mesh/for_listed_or_all.hpp"

namespace geodrome::chen_han {

RowLabels::RowLabels(const std::vector<DirectList>& lists) : lists_(lists), labels_(lists.size()) {
  for (const DirectList& list : lists) directed_.push_back(list.directed().data());
}

void RowLabels::begin(Index source, double distance) {
  forget();
  set(source, distance, {});
  relax(distance, lists_[source].paths());
}

void RowLabels::begin(Index source, double distance, std::span<const FoundPath> paths) {
  forget();
  set(source, distance, {});
  for (const FoundPath& path : paths)
    set(path.target, distance + path.length, lists_[path.target].onward(path.arrival));
}

void RowLabels::forget() {
  for_listed_or_all(reached_, labels_.size(), [this](Index v) { labels_[v] = {}; });
  reached_.clear();
  queue_.clear();
  counts_ = {};
}

void RowLabels::go_on(Index vertex) {
  const Label label = labels_[vertex];
  if (label.onward.ends()) return;
  ++counts_.settled;
  const DirectList& list = lists_[vertex];
  if (!list.for_any().empty()) relax_any(label.distance, list.for_any());
  for (const std::span<const DirectPath> paths : list.directed(label.onward)) relax(label.distance, paths);
}

void RowLabels::relax(double distance, std::span<const DirectPath> paths) {
  counts_.relaxed += paths.size();
  for (const DirectPath& path : paths) {
    const double way = distance + path.length;
    if (way < labels_[path.target].distance) set(path.target, way, path.onward);
  }
}

/// Two vertices in one place up to rounding: which is nearer is rounding as well, so both go on to all sides.
void RowLabels::relax_any(double distance, std::span<const DirectPath> paths) {
  counts_.relaxed += paths.size();
  for (const DirectPath& path : paths) {
    Label& label = labels_[path.target];
    const DirectList& list = lists_[path.target];
    const double way = distance + path.length;
    if (way < label.distance) {
      set(path.target, way, path.onward);
    } else if (list.is_all(path.onward) && !list.is_all(label.onward)) {
      label.onward = path.onward;
      wait(path.target);
    }
  }
}

/// A vertex that goes on to all sides still does if it is nearer by next to nothing.
void RowLabels::set(Index vertex, double distance, Onward onward) {
  constexpr double next_to_nothing = 1e-9;
  Label& label = labels_[vertex];
  if (label.distance == infinity)
    reached_.push_back(vertex);
  else if (distance >= label.distance * (1 - next_to_nothing) && lists_[vertex].is_all(label.onward))
    onward = label.onward;
  label.distance = distance;
  label.onward = onward;
  if (!onward.ends()) wait(vertex);
}

void RowLabels::wait(Index vertex) {
  Label& label = labels_[vertex];
  const auto key = static_cast<float>(std::min(label.distance, 1e38));
  if (!(key < label.key)) return;
  label.key = key;
  constexpr std::size_t paths_a_line = 4, most = 16;
  const DirectPath* const first = directed_[vertex] + label.onward.first;
  for (std::size_t i = 0; i < most && i < label.onward.count; i += paths_a_line) prefetch(first + i);
  queue_.push(vertex, key);
}

}  // namespace geodrome::chen_han
