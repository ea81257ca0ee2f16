// SPDX-License-Identifier: MIT
#include "plugins/tangent_jet/smooth/fit_size.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "plugins/common/parallel_for.hpp"
#include "plugins/common/points/frame.hpp"
#include "plugins/tangent_jet/smooth/quartic.hpp"

namespace geodrome {
namespace {

constexpr std::size_t most_looked_at = 256;  // the mean of a square is then known to a tenth

/// A degree that may be fitted. What it leaves out at the middle grows with the fourth and the sixth power of the
/// radius, so with the square and the cube of the number of points: the change from half of them is 3/4 and 7/8 of it.
struct Degree {
  int degree, size;
  double of_change;
};
constexpr std::array<Degree, 2> degrees{{{3, 10, 4.0 / 3}, {4, quartic_size, 8.0 / 7}}};

/// The points around a vertex over its tangent plane, nearest first.
struct VertexView {
  std::vector<Neighbour> around;
  std::vector<std::array<double, 2>> at;
  Eigen::VectorXd height;
};

VertexView view_from(const JetPoints& points, const Vec3& vertex) {
  VertexView result;
  points.places.nearest(vertex, 1, result.around);
  const Vec3 n = points.normal[result.around[0].index], u = tangent_to(n), v = cross(n, u);
  points.places.nearest(vertex, most_jet_points, result.around);
  result.height.resize(static_cast<Eigen::Index>(result.around.size()));
  for (std::size_t i = 0; i < result.around.size(); ++i) {
    const Vec3 d = points.raw[result.around[i].index] - vertex;
    result.at.push_back({dot(d, u), dot(d, v)});
    result.height[static_cast<Eigen::Index>(i)] = dot(d, n);
  }
  return result;
}

/// By how much the height at the vertex of the jet that is fitted to the first `count` points changes with that of each
/// of them. Nothing where they do not determine it.
std::optional<Eigen::VectorXd> influence(const VertexView& view, std::size_t count, const Degree& of) {
  const auto size = static_cast<Eigen::Index>(count);
  Eigen::MatrixXd basis(quartic_size, size);
  Eigen::VectorXd weight(size);
  const double squared_radius = view.around[count - 1].squared_distance, radius = std::sqrt(squared_radius);
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto k = static_cast<std::size_t>(i);
    weight[i] = std::exp(-noisy_decay * view.around[k].squared_distance / squared_radius);
    basis.col(i) = monomials(view.at[k][0] / radius, view.at[k][1] / radius);
  }
  const auto used = basis.topRows(of.size);
  const Eigen::LLT<Eigen::MatrixXd> factors(used * weight.asDiagonal() * used.transpose());
  if (factors.info() != Eigen::Success) return {};
  return weight.asDiagonal() * (used.transpose() * factors.solve(Eigen::VectorXd::Unit(of.size, 0)));
}

/// What is known of the squared error of heights, for one number of points.
struct SquaredError {
  double of_noise = 0;  ///< for a sigma of 1
  double change = 0;    ///< squared change from half the points, beyond that of noise; may be below 0
  bool known = false;
};

/// For 32, 64, ... points.
using Ladder = std::vector<SquaredError>;

Ladder squared_errors(const VertexView& view, const Degree& of, double sigma) {
  Ladder ladder;
  std::optional<Eigen::VectorXd> half;
  for (std::size_t count = fewest_jet_points; count <= view.around.size(); count *= 2) {
    const auto all = influence(view, count, of);
    SquaredError& error = ladder.emplace_back();
    if (all && half) {
      Eigen::VectorXd differs = *all;
      differs.head(half->size()) -= *half;
      const double change = differs.dot(view.height.head(differs.size()));
      error.change = change * change - sigma * sigma * differs.squaredNorm();
    }
    if (all && (half || ladder.size() == 1)) error.known = true, error.of_noise = all->squaredNorm();
    half = all;
  }
  return ladder;
}

/// The means of what is known.
SquaredError mean_of(std::span<const Ladder> ladders, std::size_t level) {
  SquaredError mean;
  double count = 0;
  for (const Ladder& ladder : ladders)
    if (level < ladder.size() && ladder[level].known)
      mean.of_noise += ladder[level].of_noise, mean.change += ladder[level].change, ++count;
  if (count > 0) mean.of_noise /= count, mean.change /= count, mean.known = true;
  return mean;
}

}  // namespace

FitSize best_fit_size(const JetPoints& points, std::span<const Vec3> vertices, RunContext& context) {
  const std::size_t looked_at = std::min(vertices.size(), most_looked_at);
  std::array<std::vector<Ladder>, degrees.size()> ladders;
  for (auto& of_degree : ladders) of_degree.resize(looked_at);
  parallel_for(points.raw.empty() ? 0 : looked_at, context, {0, 0}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const VertexView view = view_from(points, vertices[i * vertices.size() / looked_at]);
      for (std::size_t d = 0; d < degrees.size(); ++d) ladders[d][i] = squared_errors(view, degrees[d], points.sigma);
    }
  });
  FitSize best;
  double least = infinity;
  for (std::size_t d = 0; d < degrees.size(); ++d)
    for (std::size_t level = 0, count = fewest_jet_points; count <= most_jet_points; ++level, count *= 2) {
      const SquaredError mean = mean_of(ladders[d], level);
      if (!mean.known) break;
      const double left_out = degrees[d].of_change * std::sqrt(std::max(0.0, mean.change));
      const double error = std::hypot(points.sigma * std::sqrt(mean.of_noise), left_out);
      if (error < least) least = error, best = {count, degrees[d].degree, left_out};
    }
  return best;
}

}  // namespace geodrome
