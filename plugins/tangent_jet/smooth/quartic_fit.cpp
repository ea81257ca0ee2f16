// SPDX-License-Identifier: MIT
#include "plugins/tangent_jet/smooth/quartic_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "plugins/common/points/frame.hpp"

namespace geodrome {
namespace {

/// A residual of fewer than nine degrees of freedom tells nothing.
constexpr std::size_t fewest_points = quartic_size + 9;
/// Pivot of the factor, as a share of the largest, below which the points do not determine a coefficient: they are in
/// fewer than five rows. Those of random neighbourhoods and of lattices are above 1e-3; what is between, leverage
/// tells.
constexpr double singular = 1e-6;

using Column = Eigen::Matrix<double, quartic_size, 1>;
/// One column per point.
using Columns = Eigen::Matrix<double, quartic_size, Eigen::Dynamic>;

/// Whether a coefficient is fitted, not 0.
bool is_fitted(int coefficient, const QuarticFit& fit) {
  return degree_of[coefficient] <= fit.degree && !(fit.pinned && coefficient == 0);
}

/// The monomials whose coefficients are fitted; 0 for the others.
Column row_of(double x, double y, const QuarticFit& fit) {
  Column b = monomials(x, y);
  for (int i = 0; i < quartic_size; ++i)
    if (!is_fitted(i, fit)) b[i] = 0;
  return b;
}

/// The points as the equations see them, in units of the radius and times the roots of their weights.
struct Equations {
  Columns basis;
  Eigen::VectorXd height, weight;
};

Equations equations(const QuarticFit& fit, const std::vector<Vec3>& points, const std::vector<Neighbour>& around,
                    double decay) {
  const auto count = static_cast<Eigen::Index>(around.size());
  Equations e{Columns(quartic_size, count), Eigen::VectorXd(count), Eigen::VectorXd(count)};
  const Quartic& frame = fit.quartic;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Neighbour& neighbour = around[static_cast<std::size_t>(i)];
    const Vec3 d = (points[neighbour.index] - frame.base) / fit.radius;
    e.weight[i] = std::exp(-decay * neighbour.squared_distance / around.back().squared_distance);
    const double root = std::sqrt(e.weight[i]);
    e.basis.col(i) = root * row_of(dot(d, frame.u), dot(d, frame.v), fit);
    e.height[i] = root * dot(d, frame.n);
  }
  return e;
}

/// The residuals' weighted sum of squares over what it is expected to be for a standard deviation of 1.
double residual_of(const Equations& e, const Column& solution, const QuarticFit::Matrix& factor) {
  const double squares = (e.height - e.basis.transpose() * solution).squaredNorm();
  const Columns reduced = factor.triangularView<Eigen::Lower>().solve(e.basis);
  const double freedom = e.weight.sum() - e.weight.dot(reduced.colwise().squaredNorm().transpose());
  return std::sqrt(squares / freedom);
}

}  // namespace

double QuarticFit::leverage(double x, double y) const {
  return factor.triangularView<Eigen::Lower>().solve(row_of(x / radius, y / radius, *this)).norm();
}

QuarticFit fit_quartic(const std::vector<Vec3>& points, const std::vector<Neighbour>& around, const Vec3& base,
                       const Vec3& normal, const FitRule& rule) {
  QuarticFit fit;
  fit.quartic = {base, tangent_to(normal), {}, normal, {}};
  fit.quartic.v = cross(normal, fit.quartic.u);
  fit.radius = std::sqrt(around.back().squared_distance);
  fit.pinned = rule.pinned, fit.degree = rule.degree;
  if (around.size() < fewest_points) return fit;

  const Equations e = equations(fit, points, around, rule.decay);
  QuarticFit::Matrix matrix = QuarticFit::Matrix::Zero();
  matrix.selfadjointView<Eigen::Lower>().rankUpdate(e.basis);
  for (int i = 0; i < quartic_size; ++i)
    if (!is_fitted(i, fit)) matrix(i, i) = 1;  // for a coefficient of 0
  const Eigen::LLT<QuarticFit::Matrix> factors(matrix);
  fit.factor = factors.matrixLLT();
  const auto pivots = fit.factor.diagonal();
  fit.determined = factors.info() == Eigen::Success && pivots.minCoeff() > singular * pivots.maxCoeff();
  if (!fit.determined) return fit;
  const Column solution = factors.solve(e.basis * e.height);
  fit.residual = fit.radius * residual_of(e, solution, fit.factor);
  for (int i = 0; i < quartic_size; ++i) fit.quartic.c[i] = solution[i] * std::pow(fit.radius, 1 - degree_of[i]);
  return fit;
}

}  // namespace geodrome
