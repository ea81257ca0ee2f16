// SPDX-License-Identifier: MIT
#include "plugins/common/mesh/bucket_queue.hpp"

#include <utility>

namespace geodrome {

void BucketQueue::clear() {
  if (in_ring_ > 0)
    for (auto& bucket : ring_) bucket.clear();
  present_.clear(), beyond_.clear();
  taken_ = enough_ = count_ = in_ring_ = 0;
  is_heap_ = false;
  present_number_ = -1, first_beyond_ = nowhere;
}

void BucketQueue::make_heap() {
  present_.erase(present_.begin(), present_.begin() + static_cast<std::ptrdiff_t>(taken_));
  taken_ = 0;
  is_heap_ = true;
  std::make_heap(present_.begin(), present_.end(), later);
}

/// Makes the next bucket that holds something the present one. What lies beyond the ring comes into it before the ring
/// passes it by.
void BucketQueue::open_next() {
  present_.clear();
  taken_ = 0;
  is_heap_ = false;
  if (in_ring_ == 0)
    present_number_ = first_beyond_;
  else
    do ++present_number_;
    while (present_number_ < first_beyond_ && bucket(present_number_).empty());
  std::vector<Entry>& next = bucket(present_number_);
  in_ring_ -= next.size();
  present_.assign(next.begin(), next.end());  // each bucket keeps its own memory, so that it settles
  next.clear();
  enough_ = std::numeric_limits<std::size_t>::max();
  if (present_number_ >= first_beyond_) {
    first_beyond_ = nowhere;
    std::swap(beyond_, coming_);
    count_ -= coming_.size();
    for (const Entry& entry : coming_) push(entry.element, entry.key);
    coming_.clear();
  }
  enough_ = 3 * present_.size() + 16;
}

std::size_t BucketQueue::bytes() const {
  std::size_t entries = present_.capacity() + beyond_.capacity() + coming_.capacity();
  for (const auto& bucket : ring_) entries += bucket.capacity();
  return entries * sizeof(Entry) + ring_.capacity() * sizeof(ring_[0]);
}

}  // namespace geodrome
