// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/checks/interval_audit.hpp"
#include "engine/checks/invariants.hpp"
#include "engine/jobs/compare/errors.hpp"
#include "engine/jobs/compare/guarantee.hpp"
#include "engine/search/smooth_distances.hpp"
#include "geodrome/engine/input.hpp"

/// The figures that a comparison of combinations of plugins finds: the values of `geodrome compare`, before they become
/// text.
namespace geodrome {

/// The cost of preparing a surface and of searching it from each source, on one thread.
struct SearchCost {
  std::size_t vertices = 0, faces = 0;
  double prepare_seconds = 0;
  std::vector<double> source_seconds;  ///< one per source
  std::optional<std::uint64_t>
      peak_bytes;                          ///< resident at most, above what was resident before; where the system tells
  std::uint64_t prepared_bytes = 0;        ///< as the prepared surface says
  std::map<std::string, double> counters;  ///< means per source; those named "largest_..." the largest

  double median_seconds() const;
};

struct GrowthStep {
  std::size_t rows = 0;  ///< of the input of this size
  SearchCost cost;
};

struct NamedCheck {
  std::string name;
  InvariantCheck check;
};

/// The distances of a combination on the smooth surface.
struct SmoothComparison {
  std::vector<double> source_seconds;  ///< one per source, the search included
  SmoothFigures paths;
  ErrorFigures errors;
  std::vector<NamedCheck> invariants;

  double median_seconds() const;
};

/// One combination of plugins: what it gave, or why it did not run.
struct CombinationFigures {
  std::string name;
  std::vector<std::pair<std::string, std::string>> stages;  ///< stage, choice
  std::string error;                                        ///< empty if it ran; else nothing below has a meaning
  int error_status = 0;                                     ///< the exit status that the error stands for
  double factor = 0;                                        ///< +inf: none is stated
  bool never_shorter = false;  ///< the solver states that no distance is below the true one
  std::vector<std::pair<std::string, double>> stage_seconds;
  SearchCost cost;
  ErrorFigures errors;
  std::optional<IntervalFigures> certified;  ///< if the solver states lower bounds
  std::vector<NamedCheck> invariants;
  GuaranteeFigures guarantee;
  std::optional<SmoothComparison> smooth;  ///< if the metric is; all else is of the triangles
  std::vector<GrowthStep> growth;          ///< smallest first, the input itself among them; empty if not asked for

  bool ran() const noexcept { return error.empty(); }
};

struct ComparedSource {
  std::string entry;
  std::optional<std::size_t> row;
  Vec3 position;
  double off_surface = 0;  ///< as `NamedPoint::off_surface`
};

struct TruthFigures {
  std::string kind;  ///< "first", "exact" or "file"
  std::string name;  ///< of the combination, the solver or the file
  std::string text;  ///< for people
};

struct ComparisonFigures {
  std::string file;
  InputKind kind = InputKind::mesh;
  std::size_t rows = 0, faces = 0;  ///< faces: of a mesh
  double diagonal = 0;
  std::vector<ComparedSource> sources;  ///< empty if no combination came as far as to place them
  TruthFigures truth;
  std::vector<CombinationFigures> combinations;
};

/// Lists the promised invariants and guarantees that the figures show to be broken, one line each.
std::vector<std::string> broken_promises(const ComparisonFigures& figures);

}  // namespace geodrome
