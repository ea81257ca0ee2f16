// SPDX-License-Identifier: MIT
#include "plugins/solver_merged_windows/bucket_queue.hpp"

#include <utility>

namespace geodrome::merged_windows {

void BucketQueue::clear() {
  if (in_ring_ > 0)
    for (auto& bucket : ring_) bucket.clear();
  heap_.clear(), beyond_.clear();
  present_ = -1, first_beyond_ = nowhere, count_ = 0, in_ring_ = 0;
}

/// Makes the next bucket that holds something the present one. What lies beyond the ring comes into it before the ring
/// passes it by.
void BucketQueue::open_next() {
  if (in_ring_ == 0)
    present_ = first_beyond_;
  else
    do ++present_;
    while (present_ < first_beyond_ && bucket(present_).empty());
  in_ring_ -= bucket(present_).size();
  std::swap(heap_, bucket(present_));
  std::make_heap(heap_.begin(), heap_.end(), later);
  if (present_ < first_beyond_) return;
  first_beyond_ = nowhere;
  const std::vector<Entry> beyond = std::exchange(beyond_, {});
  count_ -= beyond.size();
  for (const Entry& entry : beyond) push(entry.element, entry.key);
}

std::size_t BucketQueue::bytes() const {
  std::size_t entries = heap_.capacity() + beyond_.capacity();
  for (const auto& bucket : ring_) entries += bucket.capacity();
  return entries * sizeof(Entry) + ring_.capacity() * sizeof(ring_[0]);
}

}  // namespace geodrome::merged_windows
