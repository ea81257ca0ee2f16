// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "engine/formats/npy_matrix.hpp"
#include "engine/jobs/compare/measure.hpp"

namespace geodrome {

/// The file that a truth names; empty if it names none. Throws OptionError for what is no truth.
std::filesystem::path truth_file(const std::string& truth);

/// Rows of a matrix for sources: one per source in their order, or, of a matrix of all pairs, those of the sources'
/// rows, start distances added; where both fit, the first. Throws InputError for another shape, naming both, and for an
/// entry that is no distance: negative, or finite and above `farthest`, as the largest number of double or float that
/// other programs write for unreachable.
DistanceRows rows_of_sources(NpyMatrix& matrix, const std::string& file, std::span<const NamedPoint> sources,
                             std::size_t rows_of_input, double farthest = infinity);

/// The distances that those of the combinations are held against.
class ComparisonTruth {
 public:
  /// `truth` as CompareJob. All but `truth` must outlive it. Throws OptionError for what is no truth or a solver that
  /// is not exact, CapabilityError for one without paths where the metric is smooth, InputError for a file that cannot
  /// be read.
  ComparisonTruth(const std::string& truth, const Input& input, const PluginHost& host, const RunSettings& settings,
                  Observer& observer);

  /// Reads the rows of a file for the sources, once. Throws as `rows_of_sources`.
  void read_file(const ComparedSurface& on);

  /// The true rows for a combination that measured `own` on `on`: of the first call, of an exact solver on the same
  /// surface, or of the file, which must have been read. Throws what the solver throws.
  const DistanceRows& rows(const std::string& combination, const ComparedSurface& on, const DistanceRows& own);
  /// The same on the smooth surface of `on`, after `rows`; those of a file are both.
  const DistanceRows& smooth_rows(const ComparedSurface& on, const DistanceRows& own);

  /// Tells whether the true rows are exact distances on the surface of the combination: those of an exact solver are,
  /// those of a file if the input is a mesh and nothing is smooth.
  bool is_exact() const;
  /// Returns the error that rounding may cause in an entry, as a share of the largest entry.
  double tolerance() const;
  TruthFigures figures() const;

 private:
  struct TrueRows {
    DistanceRows flat, smooth;
  };
  enum class Kind { first, exact, file };

  const Input& input_;
  const PluginHost& host_;
  const RunSettings& settings_;
  Observer& observer_;
  Kind kind_ = Kind::first;
  Plugin<ShortestPathSolver> solver_;  // exact
  std::string name_;                   // of the first combination, the exact solver, or the file
  std::optional<NpyMatrix> matrix_;
  std::optional<DistanceRows> same_for_all_, smooth_of_first_;
  std::map<const PlacedSurface*, TrueRows> of_surface_;
};

}  // namespace geodrome
