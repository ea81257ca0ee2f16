// SPDX-License-Identifier: MIT
#include "plugins/tangent_jet/jet_tangents.hpp"

#include <algorithm>
#include <utility>

#include "geodrome/spatial_order.hpp"
#include "plugins/common/points/live_points.hpp"
#include "plugins/common/points/local_plane.hpp"
#include "plugins/tangent_jet/noise.hpp"
#include "plugins/tangent_jet/smoothing.hpp"

namespace geodrome {
namespace {

/// Dropping an outlier uncovers the next; on outliers spread over the bounding box there were at most four rounds.
constexpr int most_rounds = 4;
/// A round that would drop more than this share says that the sample is no surface as these rules see it, not that a
/// third of it is wrong: it drops none.
constexpr double too_many = 1.0 / 3;

/// The points that are left, with their jets.
struct Cloud {
  LivePoints live;
  Neighbours neighbours;
  std::vector<Index> order;
  std::vector<LocalJet> jets;

  explicit Cloud(LivePoints points)
      : live(std::move(points)), neighbours(live.points), order(spatial_order(live.points)), jets(live.size()) {}

  void make_jet(Index at, std::size_t k, std::vector<Neighbour>& around) {
    jets[at] = local_jet(neighbours, at, k, around);
    if (jets[at].collinear) throw_collinear(live.sample_index[at], live.size());
  }
};

Cloud whole_cloud(const PointSample& sample, std::size_t k, RunContext& context) {
  Cloud cloud(live_points(sample, std::vector(sample.size(), PointState::ok)));
  parallel_for(cloud.live.size(), context, {0, 0.5}, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> around;
    for (std::size_t i = begin; i < end; ++i) cloud.make_jet(cloud.order[i], k, around);
  });
  return cloud;
}

/// The cloud without the outliers. Only jets that used one of them are made again.
Cloud without(const Cloud& old, const std::vector<bool>& outlier, std::size_t k, RunContext& context) {
  LivePoints live;
  std::vector<Vec3> dropped;
  std::vector<Index> old_index, new_index(old.live.size(), no_index);
  for (Index i = 0; i < old.live.size(); ++i) {
    if (outlier[i]) {
      dropped.push_back(old.live.points[i]);
      continue;
    }
    new_index[i] = static_cast<Index>(live.size());
    old_index.push_back(i);
    live.points.push_back(old.live.points[i]);
    live.sample_index.push_back(old.live.sample_index[i]);
  }
  const Neighbours gone(std::move(dropped));
  Cloud cloud(std::move(live));
  parallel_for(cloud.live.size(), context, {0.5, 0.5}, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> around;
    for (std::size_t i = begin; i < end; ++i) {
      const Index at = cloud.order[i];
      LocalJet& jet = cloud.jets[at];
      jet = old.jets[old_index[at]];
      gone.within(cloud.live.points[at], jet.radius, around);
      if (around.empty())
        for (Index& near : jet.near) near = near == no_index ? no_index : new_index[near];
      else
        cloud.make_jet(at, k, around);
    }
  });
  return cloud;
}

/// Drops outliers round by round; returns the noise of what is left.
Noise drop_outliers(Cloud& cloud, std::size_t k, OutlierRule rule, RunContext& context) {
  Noise noise = estimate_noise(cloud.neighbours, cloud.order, context);
  for (int round = 0; round < most_rounds; ++round) {
    const std::vector<bool> outlier =
        find_outliers(cloud.live.points, cloud.jets, noise.significant ? noise.sigma : 0, rule);
    const auto count = static_cast<std::size_t>(std::count(outlier.begin(), outlier.end(), true));
    if (count == 0 || static_cast<double>(count) > too_many * static_cast<double>(cloud.live.size())) break;
    cloud = without(cloud, outlier, k, context);
    noise = estimate_noise(cloud.neighbours, cloud.order, context);
    if (rule == OutlierRule::distance) break;
  }
  return noise;
}

/// The planes of the points that are left, in the order of the cloud.
std::vector<TangentPlane> jet_planes(const Cloud& cloud) {
  std::vector<TangentPlane> planes;
  for (std::size_t i = 0; i < cloud.live.size(); ++i)
    planes.push_back({cloud.live.points[i], cloud.jets[i].normal, cloud.jets[i].residual});
  return planes;
}

}  // namespace

Tangents JetTangents::estimate(const PointSample& sample, RunContext& context) const {
  require_three_points(sample.size());
  Tangents tangents;
  tangents.state.assign(sample.size(), PointState::dropped);
  Cloud cloud = whole_cloud(sample, settings_.k, context);
  for (std::size_t i = 0; i < sample.size(); ++i)
    tangents.plane.push_back({sample.points[i], cloud.jets[i].plane_normal, cloud.jets[i].residual});

  const Noise noise = drop_outliers(cloud, settings_.k, settings_.outliers, context);
  const bool smooth =
      settings_.smooth == Smooth::always || (settings_.smooth == Smooth::where_noisy && noise.significant);
  std::vector<TangentPlane> planes =
      smooth ? smoothed_planes(cloud.neighbours, cloud.order, noise.neighbourhood, context, {0.5, 1})
             : jet_planes(cloud);
  const std::size_t restored = smooth ? separate(planes, cloud.live.points) : 0;
  std::size_t grown = 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Index at = cloud.live.sample_index[i];
    tangents.plane[at] = planes[i];
    tangents.state[at] = PointState::ok;
    grown += cloud.jets[i].grown;
  }
  tangents.sigma = smooth || noise.significant ? noise.sigma : 0;
  context.measure("sigma", tangents.sigma);
  context.measure("spacing", noise.spacing);
  context.measure("smoothed", smooth ? static_cast<double>(planes.size() - restored) : 0);
  context.measure("smoothing_neighbours", smooth ? static_cast<double>(noise.neighbourhood) : 0);
  context.measure("restored", static_cast<double>(restored));
  context.measure("outliers", static_cast<double>(sample.size() - planes.size()));
  context.measure("grown_neighbourhoods", static_cast<double>(grown));
  context.progress(1);
  return tangents;
}

}  // namespace geodrome
