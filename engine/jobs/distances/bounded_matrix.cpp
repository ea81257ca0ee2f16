// SPDX-License-Identifier: MIT
#include "engine/jobs/distances/bounded_matrix.hpp"

#include <cmath>
#include <vector>

namespace geodrome {

namespace {

/// The largest float that is not above a bound.
double rounded_down(double bound) {
  const auto nearest = static_cast<float>(bound);
  return nearest > bound ? std::nextafter(nearest, 0.0F) : nearest;
}

}  // namespace

BoundedMatrix::BoundedMatrix(const MatrixFile::Spec& spec, const MatrixFile::Spec& bounds, bool resume)
    : matrix_(MatrixFile::open(spec, resume)), columns_(spec.columns), scalar_(spec.scalar) {
  if (!bounds.out.empty()) bounds_.emplace(MatrixFile::open(bounds, resume));
}

void BoundedMatrix::write(std::uint64_t row, std::span<const double> values) {
  if (!matrix_.has(row)) matrix_.write(row, values.first(columns_));
  if (!bounds_ || bounds_->has(row)) return;
  const std::span<const double> bounds = values.subspan(columns_);
  if (scalar_ == ScalarType::float64) return bounds_->write(row, bounds);
  std::vector<double> rounded;
  for (const double bound : bounds) rounded.push_back(rounded_down(bound));
  bounds_->write(row, rounded);
}

void BoundedMatrix::finish() {
  if (bounds_) bounds_->finish();
  matrix_.finish();
}

}  // namespace geodrome
