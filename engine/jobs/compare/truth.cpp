// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/truth.hpp"

#include <algorithm>
#include <cmath>

#include "engine/formats/ending.hpp"
#include "engine/formats/number_text.hpp"
#include "engine/jobs/compare/smooth.hpp"

namespace geodrome {

namespace {

constexpr std::string_view exact_prefix = "exact:";

std::string shape(std::size_t rows, std::size_t columns) {
  return "(" + std::to_string(rows) + ", " + std::to_string(columns) + ")";
}

void check_entries(const std::vector<double>& row, const std::string& file, std::uint64_t number, double farthest) {
  for (std::size_t j = 0; j < row.size(); ++j) {
    const auto entry = [&] { return file + ": row " + std::to_string(number) + ", column " + std::to_string(j); };
    if (row[j] < 0)
      throw InputError(InputFault::range, entry() + " is " + std::to_string(row[j]) + ", which is no distance",
                       "distances are >= 0, inf for unreachable, nan for not computed");
    if (std::isfinite(row[j]) && row[j] > farthest)
      throw InputError(InputFault::range,
                       entry() + " is " + number_text(row[j]) + ", longer than any path on the input can be (" +
                           number_text(farthest) + ")",
                       "write inf for unreachable, where other programs write a very large number");
  }
}

/// A distance above which there is none: a shortest path is no longer than one along edges, which visits each vertex
/// once, and no edge is longer than the diagonal. The surface that a cloud is a sample of may have longer ones.
double farthest_on(const Input& input, std::span<const NamedPoint> sources) {
  constexpr double unknown_surface = 1e3;
  double weight = 1, start = 0;
  for (const double other : input.weights) weight = std::max(weight, other);
  for (const NamedPoint& source : sources) start = std::max(start, source.start);
  const double hops = static_cast<double>(input.positions.size() + 2);
  return hops * input.facts.bounding_box_diagonal * weight * (input.kind == InputKind::mesh ? 1 : unknown_surface) +
         start;
}

std::uint64_t row_of_input(const NamedPoint& source, const std::string& file) {
  if (source.row != no_index) return source.row;
  throw InputError(InputFault::index,
                   file + ": is a matrix of all pairs, which has no row for the source " + source.label,
                   "name sources by their rows, or give one row per source");
}

}  // namespace

std::filesystem::path truth_file(const std::string& truth) {
  if (truth == "first" || truth == "exact") return {};
  if (truth.starts_with(exact_prefix) && truth.size() > exact_prefix.size()) return {};
  if (has_ending(truth, ".npy")) return truth;
  throw OptionError("the truth '" + truth + "' is none", "say first, exact, exact:SOLVER or FILE.npy");
}

DistanceRows rows_of_sources(NpyMatrix& matrix, const std::string& file, std::span<const NamedPoint> sources,
                             std::size_t rows_of_input, double farthest) {
  const bool one_each = matrix.rows() == sources.size(), all_pairs = matrix.rows() == rows_of_input;
  if (matrix.columns() != rows_of_input || !(one_each || all_pairs))
    throw InputError(InputFault::unsupported,
                     file + ": has shape " + matrix.shape_text() + ", but must have " +
                         shape(sources.size(), rows_of_input) + " (sources x rows of the input) or " +
                         shape(rows_of_input, rows_of_input),
                     "give it the sources and the input that it was made with");
  DistanceRows rows;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const std::uint64_t number = one_each ? i : row_of_input(sources[i], file);
    rows.push_back(matrix.read(number));
    check_entries(rows.back(), file, number, farthest);
    if (!one_each)
      for (double& distance : rows.back()) distance += sources[i].start;
  }
  return rows;
}

ComparisonTruth::ComparisonTruth(const std::string& truth, const Input& input, const PluginHost& host,
                                 const RunSettings& settings, Observer& observer)
    : input_(input), host_(host), settings_(settings), observer_(observer) {
  if (const auto file = truth_file(truth); !file.empty()) {
    kind_ = Kind::file, name_ = truth;
    matrix_.emplace(file);
  } else if (truth != "first") {
    kind_ = Kind::exact;
    name_ = truth == "exact" ? StageChoice().solver : truth.substr(exact_prefix.size());
    solver_ = host.load<ShortestPathSolver>(name_);
    if (settings.metric == Metric::smooth) demand(solver_.info, Provides::paths);
    if (solver_.factor != 1)
      throw OptionError("the truth " + truth + ": that solver is not exact", "choose one with factor 1, as chen_han");
  }
}

void ComparisonTruth::read_file(const ComparedSurface& on) {
  if (matrix_ && !same_for_all_)
    same_for_all_ = rows_of_sources(*matrix_, name_, on.sources, on.targets.size(), farthest_on(input_, on.sources));
}

const DistanceRows& ComparisonTruth::rows(const std::string& combination, const ComparedSurface& on,
                                          const DistanceRows& own) {
  if (kind_ == Kind::exact) {
    TrueRows& rows = of_surface_[on.surface.get()];
    if (rows.flat.empty()) {
      Measurement measured = measure(on, solver_, host_, settings_, "truth", observer_);
      if (on.metric) rows.smooth = measure_smooth(on, measured.solver, settings_, "truth", observer_).rows;
      rows.flat = std::move(measured.rows);
    }
    return rows.flat;
  }
  if (!same_for_all_ && kind_ == Kind::first) same_for_all_ = own, name_ = combination;
  return *same_for_all_;
}

const DistanceRows& ComparisonTruth::smooth_rows(const ComparedSurface& on, const DistanceRows& own) {
  if (kind_ == Kind::exact) return of_surface_.at(on.surface.get()).smooth;
  if (kind_ == Kind::file) return *same_for_all_;
  if (!smooth_of_first_) smooth_of_first_ = own;
  return *smooth_of_first_;
}

bool ComparisonTruth::is_exact() const {
  const bool on_triangles = input_.kind == InputKind::mesh && settings_.metric == Metric::flat;
  return kind_ == Kind::exact || (kind_ == Kind::file && on_triangles);
}

double ComparisonTruth::tolerance() const {
  return matrix_ && matrix_->scalar() == ScalarType::float32 ? float32_tolerance : float64_tolerance;
}

TruthFigures ComparisonTruth::figures() const {
  switch (kind_) {
    case Kind::exact:
      return {"exact", name_, "The exact distances by " + name_ + " on the surface of each combination."};
    case Kind::file:
      return {"file", name_, "The distances in " + name_ + "."};
    default:
      return {"first", name_,
              name_.empty() ? "None: no combination ran."
                            : "The distances of " + name_ + ", the first combination that ran."};
  }
}

}  // namespace geodrome
