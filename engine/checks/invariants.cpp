// SPDX-License-Identifier: MIT
#include "engine/checks/invariants.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <unordered_map>

#include "engine/checks/rounding_scale.hpp"
#include "engine/checks/seeded_subset.hpp"

namespace geodrome {
namespace {

/// Draws below `bound` from the generator's own bits, the same with every standard library. The bias is below
/// bound / 2^64.
std::uint64_t draw(std::mt19937_64& random, std::uint64_t bound) { return random() % bound; }

/// A row of the matrix that was read, without its start distance.
struct SampledRow {
  std::uint64_t row;
  std::optional<std::uint64_t> column;  ///< where the same point is a target
  std::vector<double> distances;
  double cut_off;  ///< what is farther is +inf
};

std::vector<SampledRow> read_sample(const MatrixView& matrix, const InvariantOptions& options) {
  std::unordered_map<std::uint64_t, std::uint64_t> column_of_id;
  for (std::uint64_t column = 0; column < matrix.column_ids.size(); ++column)
    column_of_id.emplace(matrix.column_ids[column], column);  // the first one stays
  const std::uint64_t columns = std::max<std::uint64_t>(matrix.column_ids.size(), 1);
  const std::uint64_t wanted = std::max<std::uint64_t>(options.entries / columns, 3);

  std::vector<SampledRow> sample;
  for (const std::uint64_t row : seeded_subset<std::uint64_t>(matrix.row_ids.size(), wanted, options.seed)) {
    const double start = matrix.starts.empty() ? 0 : matrix.starts[row];
    SampledRow sampled{row, std::nullopt, matrix.read(row), options.radius - start};
    if (const auto found = column_of_id.find(matrix.row_ids[row]); found != column_of_id.end())
      sampled.column = found->second;
    for (double& distance : sampled.distances) distance -= start;
    sample.push_back(std::move(sampled));
  }
  return sample;
}

double scale_of(const MatrixView& matrix, const std::vector<SampledRow>& sample, double smallest_weight) {
  RoundingScale scale(smallest_weight);
  for (const SampledRow& row : sample) scale.distances(row.distances);
  return scale.points(matrix.row_points).points(matrix.column_points).value();
}

/// The part that the checks have in common: how far a <= b is violated, and the record of it.
class Checker {
 public:
  Checker(const MatrixView& matrix, const InvariantOptions& options, Invariants& result)
      : matrix_(matrix), options_(options), result_(result) {
    const double tolerance = options.float32 ? float32_tolerance : float64_tolerance;
    for (InvariantCheck* check : {&result.identity, &result.euclid, &result.symmetry, &result.triangle})
      check->tolerance = tolerance;
    result.symmetry.expected = result.triangle.expected = std::isfinite(options.factor) && options.one_surface;
    result.euclid.expected = options.bounded;
    factor_ = std::isfinite(options.factor) ? options.factor : 1;
    // Each distance that takes part may be off by the change.
    const double change = result.scale > 0 ? options.change / result.scale : options.change;
    result.symmetry.tolerance += (1 + factor_) * change, result.triangle.tolerance += (1 + 2 * factor_) * change;
  }

  /// Every entry of a row.
  void check_row(const SampledRow& source) {
    for (std::uint64_t column = 0; column < source.distances.size(); ++column) {
      const double d = source.distances[column];
      const double straight = distance(matrix_.row_points[source.row], matrix_.column_points[column]);
      const bool has_distance = std::isfinite(straight);
      ++result_.entries;
      result_.infinite += d == infinity;
      result_.not_computed += std::isnan(d);
      if (has_distance) record(result_.computed, std::isnan(d) ? 1 : 0, source.row, column);
      if (!has_distance || std::isnan(d)) continue;
      record(result_.euclid, excess(options_.smallest_weight * straight, d), source.row, column);
      // A source that starts beyond the cut-off does not even reach itself.
      if (matrix_.row_ids[source.row] == matrix_.column_ids[column] && source.cut_off >= 0)
        record(result_.identity, excess(std::abs(d), 0), source.row, column);
    }
  }

  /// D(s, t) <= factor D(t, s).
  void check_pair(const SampledRow& s, const SampledRow& t) {
    if (!s.column || !t.column) return;
    const double there = s.distances[*t.column], back = t.distances[*s.column];
    if (std::isnan(there) || std::isnan(back)) return;
    record(result_.symmetry, excess(at_least(there, s), factor_ * back), s.row, *t.column);
  }

  /// D(s, u) <= factor (D(s, t) + D(t, u)).
  void check_triple(const SampledRow& s, const SampledRow& t, std::uint64_t u) {
    if (!t.column) return;
    const double direct = s.distances[u], first = s.distances[*t.column], second = t.distances[u];
    if (std::isnan(direct) || std::isnan(first) || std::isnan(second)) return;
    record(result_.triangle, excess(at_least(direct, s), factor_ * (first + second)), s.row, u, t.row);
  }

 private:
  /// What is known of a distance from below: beyond the cut-off it is the cut-off.
  static double at_least(double value, const SampledRow& row) { return value == infinity ? row.cut_off : value; }

  /// (low - high) / scale; what reaches infinity on the high side violates nothing.
  double excess(double low, double high) const {
    if (high == infinity) return -infinity;
    return result_.scale > 0 ? (low - high) / result_.scale : low - high;
  }

  static void record(InvariantCheck& check, double violation, std::uint64_t row, std::uint64_t column,
                     std::uint64_t middle = 0) {
    ++check.tested;
    check.violated += violation > check.tolerance;
    if (!(violation > check.worst) && check.tested > 1) return;
    check.worst = violation;
    check.row = row, check.column = column, check.middle = middle;
  }

  const MatrixView& matrix_;
  const InvariantOptions& options_;
  Invariants& result_;
  double factor_;
};

}  // namespace

Invariants check_invariants(const MatrixView& matrix, const InvariantOptions& options) {
  const std::vector<SampledRow> sample = read_sample(matrix, options);
  Invariants result;
  result.rows = sample.size();
  result.scale = scale_of(matrix, sample, options.smallest_weight);
  Checker checker(matrix, options, result);
  for (const SampledRow& row : sample) checker.check_row(row);
  for (const SampledRow& s : sample)
    for (const SampledRow& t : sample)
      if (&s != &t) checker.check_pair(s, t);
  if (sample.empty() || matrix.column_ids.empty()) return result;
  // A stream of its own, so that the choice of rows does not shift the triples.
  std::mt19937_64 random(options.seed ^ 0x9e3779b97f4a7c15u);
  for (std::uint64_t i = 0; i < options.triples; ++i) {
    const SampledRow& s = sample[draw(random, sample.size())];
    const SampledRow& t = sample[draw(random, sample.size())];
    checker.check_triple(s, t, draw(random, matrix.column_ids.size()));
  }
  return result;
}

}  // namespace geodrome
