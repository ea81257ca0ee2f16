// SPDX-License-Identifier: MIT
#include "plugins/decimator_greedy/greedy_decimation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <string>

#include "plugins/common/parallel_for.hpp"
#include "plugins/common/points/live_points.hpp"
#include "plugins/common/points/neighbours.hpp"

namespace geodrome {
namespace {

/// Lemma 6: no other kept point is in the closed ball of this share of psi.
constexpr double lemma_6_share = 17.0 / 18;

/// Not std::shuffle, whose result the standard leaves to the library.
std::vector<Index> shuffled(std::size_t count, std::uint64_t seed) {
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), Index{0});
  std::mt19937_64 random(seed);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

/// Algorithm 1 on packed points; ascending indices into them.
std::vector<Index> decimate(const LivePoints& live, const std::vector<double>& psi, RunContext& context) {
  const Neighbours dense(live.points);
  std::vector<bool> removed(live.size(), false);
  std::vector<Index> kept;
  std::vector<Neighbour> ball;
  std::size_t done = 0;
  for (const Index s : shuffled(live.size(), context.seed())) {
    if (done++ % 1024 == 0) {
      context.throw_if_cancelled();
      context.progress(0.8 * static_cast<double>(done) / static_cast<double>(live.size()));
    }
    if (removed[s]) continue;
    kept.push_back(s);
    dense.within(live.points[s], psi[live.sample_index[s]], ball);
    for (const Neighbour& n : ball) removed[n.index] = true;
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

/// The smallest distance to the nearest other kept point, relative to psi; throws if Lemma 6 does not hold.
double check_lemma_6(const PointSample& sample, const std::vector<Index>& kept, const std::vector<double>& psi,
                     RunContext& context) {
  std::vector<Vec3> points;
  for (const Index s : kept) points.push_back(sample.points[s]);
  const Neighbours neighbours(std::move(points));
  std::vector<double> ratio(kept.size());
  parallel_for(kept.size(), context, {0.8, 1}, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> nearest;
    for (std::size_t i = begin; i < end; ++i) {
      neighbours.nearest(neighbours.points()[i], 1, nearest, static_cast<Index>(i));
      ratio[i] = std::sqrt(nearest.front().squared_distance) / psi[kept[i]];
      if (ratio[i] > lemma_6_share) continue;
      throw NumericalError("kept points " + std::to_string(kept[i]) + " and " +
                               std::to_string(kept[nearest.front().index]) + " are nearer than 17/18 psi (Lemma 6)",
                           "psi is no 1/18-Lipschitz function: choose another control plugin");
    }
  });
  return *std::min_element(ratio.begin(), ratio.end());
}

}  // namespace

std::vector<Index> GreedyDecimation::select(const PointSample& sample, const Control& control,
                                            RunContext& context) const {
  const LivePoints live = live_points(sample, control.state);
  std::vector<Index> kept = decimate(live, control.psi, context);
  for (Index& s : kept) s = live.sample_index[s];
  if (kept.size() > 1) context.measure("lemma_6_worst_ratio", check_lemma_6(sample, kept, control.psi, context));
  context.progress(1);
  return kept;
}

}  // namespace geodrome
