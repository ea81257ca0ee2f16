// SPDX-License-Identifier: MIT
#include "tools/bench/samples/manifold_task.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "geodrome/errors.hpp"
#include "plugins/common/points/neighbours.hpp"
#include "tools/bench/samples/distance_errors.hpp"
#include "tools/shapes/random.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::bench {
namespace {

/// The largest |d(a, b) - d(b, a)| among the sources, which are targets of each other.
double asymmetry_of(const ManifoldTask& task) {
  const auto between = [&](std::size_t i, std::size_t j) {
    const auto found = std::ranges::lower_bound(task.targets[i], task.sources[j]);
    return task.truth[i][static_cast<std::size_t>(found - task.targets[i].begin())];
  };
  double largest = 0;
  for (std::size_t i = 0; i < task.sources.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) largest = std::max(largest, std::abs(between(i, j) - between(j, i)));
  return largest;
}

}  // namespace

std::vector<Index> choose_rows(std::size_t points, std::size_t count, std::uint64_t seed) {
  shapes::Random random(seed);
  std::set<Index> chosen;
  while (chosen.size() < std::min(count, points)) chosen.insert(static_cast<Index>(random.index(points)));
  return {chosen.begin(), chosen.end()};
}

double largest_hole(const std::string& shape, const PointSample& sample, std::uint64_t seed) {
  constexpr std::size_t probes = 100'000;
  constexpr std::uint64_t other_numbers = 0x65707369;  // the probes must not be the sample
  const Neighbours tree(sample.points);
  double worst = 0;
  std::vector<Neighbour> found;
  for (const Vec3& p : shapes::sample(shape, {.points = probes, .seed = seed ^ other_numbers}).points) {
    tree.nearest(p, 1, found);
    worst = std::max(worst, found.front().squared_distance);
  }
  return std::sqrt(worst);
}

double manifold_epsilon(const std::string& shape, const PointSample& sample, std::uint64_t seed) {
  const auto size = feature_size(shape);
  if (!size) throw OptionError("no feature size is known of '" + shape + "'", "valid shapes: sphere, torus, trefoil");
  return largest_hole(shape, sample, seed) / *size;
}

std::vector<std::vector<double>> at_targets(const ManifoldTask& task, const std::vector<std::vector<double>>& rows) {
  std::vector<std::vector<double>> chosen(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const Index target : task.targets[i]) chosen[i].push_back(rows[i][target]);
  return chosen;
}

TaskMaker::TaskMaker(const std::string& shape, const TruthChoice& choice, const PluginHost& host)
    : choice_(choice), truth_(shape, choice.faces, host.load<ShortestPathSolver>(choice.solver)) {}

std::vector<Index> TaskMaker::targets_of(const ManifoldTask& task, std::span<const Vec3> feet, Index source,
                                         std::uint64_t seed) const {
  const std::vector<double> rough = truth_.rough(feet);
  const double limit = near_share * *std::ranges::max_element(rough);
  std::vector<Index> near;
  for (Index i = 0; i < rough.size(); ++i)
    if (rough[i] < limit) near.push_back(i);
  const std::uint64_t own = seed + source;  // other targets for every source
  std::set<Index> chosen(task.sources.begin(), task.sources.end());
  for (const Index i : choose_rows(feet.size(), choice_.targets, own)) chosen.insert(i);
  for (const Index i : choose_rows(near.size(), choice_.near, own)) chosen.insert(near[i]);
  chosen.erase(source);
  return {chosen.begin(), chosen.end()};
}

ManifoldTask TaskMaker::make(const SampleCase& wanted, std::size_t sources) {
  if (wanted.sampling == "jittered") throw OptionError("jittered points are beside the shape");
  SampleCase without_noise = wanted;
  without_noise.noise = 0;
  ManifoldTask task;
  task.sample = make_sample(wanted);
  const PointSample feet = make_sample(without_noise);  // noise comes after the points are drawn
  task.sources = choose_rows(feet.size(), sources, wanted.seed);
  task.hole = largest_hole(wanted.shape, feet, wanted.seed);
  for (const Index source : task.sources) {
    truth_.start(feet.points[source]);
    std::vector<double>& row = task.truth.emplace_back();
    for (const Index target : task.targets.emplace_back(targets_of(task, feet.points, source, wanted.seed)))
      row.push_back(truth_.distance(feet.points[target]));
  }
  task.asymmetry = asymmetry_of(task);
  return task;
}

}  // namespace geodrome::bench
