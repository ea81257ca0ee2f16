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
#include "plugins/decimator_greedy/open_sample.hpp"

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

/// What is kept, as ascending indices into packed points.
struct Kept {
  std::vector<Index> all;
  std::vector<Index> thinned;  ///< those that Lemma 6 speaks of
};

/// Algorithm 1 on packed points. The rim of an open sample comes first, and no point of it removes another; bent points
/// remove none.
Kept decimate(const LivePoints& live, const std::vector<double>& psi, const OpenSample& open, RunContext& context) {
  const Neighbours dense(live.points);
  std::vector<bool> removed(live.size(), false);
  Kept kept;
  std::vector<Neighbour> ball;
  const auto remove_around = [&](Index s) {
    dense.within(live.points[s], psi[live.sample_index[s]], ball);
    for (const Neighbour& n : ball) removed[n.index] = true;
  };
  const std::vector<Index> order = shuffled(live.size(), context.seed());
  for (const Index s : order) {
    if (!open.on_rim(s) || removed[s]) continue;
    kept.all.push_back(s);
    dense.within(live.points[s], open.rim_step[s], ball);
    for (const Neighbour& n : ball) removed[n.index] = removed[n.index] || open.on_rim(n.index);
  }
  for (const Index s : std::vector(kept.all)) remove_around(s);
  std::size_t done = 0;
  for (const Index s : order) {
    if (done++ % 1024 == 0) {
      context.throw_if_cancelled();
      context.progress(0.3 + 0.5 * static_cast<double>(done) / static_cast<double>(live.size()));
    }
    if (removed[s] || open.on_rim(s)) continue;
    kept.all.push_back(s);
    if (open.is_bent(s)) continue;
    kept.thinned.push_back(s);
    remove_around(s);
  }
  std::sort(kept.all.begin(), kept.all.end());
  std::sort(kept.thinned.begin(), kept.thinned.end());
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
  const OpenSample open = open_sample(sample, control, live, context);
  Kept kept = decimate(live, control.psi, open, context);
  for (std::vector<Index>* list : {&kept.all, &kept.thinned})
    for (Index& s : *list) s = live.sample_index[s];
  if (kept.thinned.size() > 1)
    context.measure("lemma_6_worst_ratio", check_lemma_6(sample, kept.thinned, control.psi, context));
  context.progress(1);
  return std::move(kept.all);
}

}  // namespace geodrome
