// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/errors.hpp"

#include <algorithm>
#include <cmath>

namespace geodrome {

namespace {

constexpr int first_half_decade = -34, last_half_decade = 2;

/// Calls `visit(D, T)` for every pair.
template <class Visitor>
void for_each_pair(const DistanceRows& distances, const DistanceRows& truth, Visitor&& visit) {
  for (std::size_t i = 0; i < distances.size(); ++i)
    for (std::size_t j = 0; j < distances[i].size(); ++j) visit(distances[i][j], truth[i][j]);
}

double largest_finite(const DistanceRows& rows) {
  double largest = 0;
  for (const auto& row : rows)
    for (const double value : row)
      if (std::isfinite(value)) largest = std::max(largest, value);
  return largest;
}

void add(ErrorSummary& summary, double error) {
  ++summary.compared;
  summary.mean += error;  // the sum, until all are in
  summary.max = std::max(summary.max, error);
}

void finish(ErrorSummary& summary) {
  if (summary.compared > 0) summary.mean /= static_cast<double>(summary.compared);
}

ErrorHistogram histogram_of(const std::vector<double>& errors) {
  ErrorHistogram histogram;
  std::vector<double> edges;
  for (int half = first_half_decade; half <= last_half_decade; ++half) {
    histogram.decades.push_back(0.5 * half);
    edges.push_back(std::pow(10, 0.5 * half));
  }
  histogram.counts.resize(edges.size() - 1);
  for (const double error : errors) {
    if (error == 0) {
      ++histogram.zero;
      continue;
    }
    // D / T - 1 is a multiple of 2^-53, so that nothing lies below the first edge.
    const auto above = std::upper_bound(edges.begin(), edges.end() - 1, error) - edges.begin();
    ++histogram.counts[static_cast<std::size_t>(above - 1)];
  }
  return histogram;
}

/// Nearest rank: the smallest error that at least this share of them does not exceed.
double quantile(const std::vector<double>& sorted, double share) {
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::max<std::size_t>(rank, 1) - 1];
}

}  // namespace

ErrorFigures compare_distances(const DistanceRows& distances, const DistanceRows& truth) {
  ErrorFigures figures;
  const double largest = largest_finite(truth);
  std::vector<double> errors;
  for_each_pair(distances, truth, [&](double d, double t) {
    figures.unreachable += std::isinf(d);
    if (std::isnan(d) || std::isnan(t)) return;
    figures.reach_differs += std::isfinite(d) != std::isfinite(t);
    if (!std::isfinite(d) || !std::isfinite(t) || t == 0) return;
    const double signed_error = d / t - 1, error = std::abs(signed_error);
    figures.max_over = std::max(figures.max_over, signed_error);
    figures.max_under = std::max(figures.max_under, -signed_error);
    errors.push_back(error);
    add(figures.all, error);
    if (t < near_share * largest) add(figures.near, error);
    if (t >= far_share * largest) add(figures.far, error);
  });
  for (ErrorSummary* summary : {&figures.all, &figures.near, &figures.far}) finish(*summary);
  figures.histogram = histogram_of(errors);
  std::sort(errors.begin(), errors.end());
  if (!errors.empty())
    for (const double share : ErrorFigures::shares) figures.quantiles.push_back(quantile(errors, share));
  return figures;
}

}  // namespace geodrome
