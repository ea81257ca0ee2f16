// SPDX-License-Identifier: MIT
#include "plugins/tangent_jet/quadric.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "plugins/common/points/frame.hpp"

namespace geodrome {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Share of the largest eigenvalue of the normal equations below which a combination of coefficients counts as not
/// determined: heights would be magnified a thousandfold. Random neighbourhoods are above 1e-3.
constexpr double undetermined = 1e-6;

Vector6 basis(double x, double y) {
  Vector6 b;
  b << 1, x, y, x * x, std::numbers::sqrt2 * x * y, y * y;
  return b;
}

}  // namespace

Vec3 Quadric::normal() const {
  const Vec3 direction = n - jet[1] * u - jet[2] * v;
  return direction / norm(direction);
}

double Quadric::residual(const Vec3& offset) const {
  return dot(offset, n) - scale * jet.dot(basis(dot(offset, u) / scale, dot(offset, v) / scale));
}

QuadricSystem::QuadricSystem(const Vec3& normal, double scale) {
  frame_.n = normal;
  frame_.u = tangent_to(normal);
  frame_.v = cross(normal, frame_.u);
  frame_.scale = scale;
}

void QuadricSystem::add(const Vec3& offset, double weight) {
  const Vec3 d = offset / frame_.scale;
  const Vector6 b = basis(dot(d, frame_.u), dot(d, frame_.v));
  matrix_.noalias() += weight * b * b.transpose();
  right_ += weight * dot(d, frame_.n) * b;
}

Quadric QuadricSystem::solve() const {
  Quadric result = frame_;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(matrix_);
  const double smallest = undetermined * solver.eigenvalues()[5];
  result.jet.setZero();
  for (int i = 0; i < 6; ++i) {
    if (!(solver.eigenvalues()[i] > smallest)) continue;
    const Vector6 direction = solver.eigenvectors().col(i);
    result.jet += direction.dot(right_) / solver.eigenvalues()[i] * direction;
    ++result.rank;
  }
  return result;
}

}  // namespace geodrome
