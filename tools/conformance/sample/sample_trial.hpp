// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include "geodrome/plugin.hpp"
#include "tools/conformance/demand_table.hpp"
#include "tools/shapes/small_samples.hpp"

namespace geodrome::conformance {

using namespace shapes::small;

/// A context whose every answer the demand decides; it watches what it is told.
class SampleContext : public QuietContext {
 public:
  explicit SampleContext(unsigned threads = 2, std::uint64_t seed = 0) : threads_(threads), seed_(seed) {}
  void progress(double fraction) override {
    if (!(fraction >= 0 && fraction <= 1)) progress_in_range = false;
  }
  bool cancelled() const noexcept override { return stop; }
  unsigned threads() const noexcept override { return threads_; }
  std::uint64_t seed() const noexcept override { return seed_; }

  std::atomic<bool> stop = false, progress_in_range = true;

 private:
  unsigned threads_;
  std::uint64_t seed_;
};

struct NamedSample {
  const char* name;
  PointSample sample;
};

/// Smooth, noisy, flat, in exact rows, tiny, huge and far away.
inline std::vector<NamedSample> usual_samples() {
  return {{"torus", torus(2000, 1, 10)},
          {"noisy ellipsoid", with_noise(ellipsoid(1500, 2), 0.02, 3)},
          {"plane", plane(800, 4)},
          {"plane grid", plane_lattice(25, 30)},
          {"tiny torus", moved(torus(1000, 5), 1e-6, {})},
          {"huge torus, far away", moved(torus(1000, 6), 1e6, {1e6, 1e6, 1e6})}};
}

}  // namespace geodrome::conformance
