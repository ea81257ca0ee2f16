// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <string_view>

#include "geodrome/engine/observer.hpp"

namespace geodrome::test {

/// Cancels a job when more than a share of the rows of its distances are there.
class StopsAtRows : public Observer {
 public:
  explicit StopsAtRows(double share) : share_(share) {}

  void progress(std::string_view stage, double fraction) override {
    if (stage == "distances" && fraction > share_) stop_ = true;
  }
  bool cancelled() const noexcept override { return stop_; }

 private:
  double share_;
  std::atomic<bool> stop_ = false;
};

}  // namespace geodrome::test
