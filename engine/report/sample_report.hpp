// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/checks/empty_places.hpp"
#include "engine/checks/guarantee.hpp"
#include "engine/checks/surface_facts.hpp"
#include "engine/checks/torn_surface.hpp"
#include "engine/checks/worst_places.hpp"
#include "engine/report/json.hpp"

namespace geodrome {

/// The distance of the live points of the input from the surface, in units of the input.
struct SurfaceDistance {
  double largest = 0, root_mean_square = 0;
  Index farthest_row = no_index;
};

/// The verdict of experience, apart from the paper: `unknown` if nothing that would tell was measured.
struct Practice {
  enum class Verdict { good, fair, doubtful, refused, unknown };
  Verdict verdict = Verdict::unknown;
  std::vector<std::string> because;
};

const char* word(Practice::Verdict verdict);
inline constexpr const char* practice_note =
    "observed, not proven: smooth shapes come out right up to epsilon 0.3, mostly up to 0.5, far above the paper's "
    "1/22";

/// Why a sample was refused.
struct Refusal {
  std::string plugin, reason, remedy;
};

/// The report on a sample, as the user is told it.
struct SampleReport {
  SampleFacts facts;
  double diagonal = 0;                          ///< of the input's bounding box
  std::optional<SurfaceFacts> surface;          ///< none if the sample was refused
  std::optional<SurfaceDistance> distance;      ///< likewise
  std::optional<EmptyPlace> empty_place;        ///< that the surface spans, if there is one
  std::optional<std::pair<Index, Index>> torn;  ///< two rows, if the surface fell apart between them
  /// The part that the surface is of; of a sample that was refused the one that could be had, with no points if none.
  std::optional<SurfacePart> part;
  std::map<std::string, StageFigure> figures;
  GuaranteeVerdict guarantee;
  Practice practice;
  /// The epsilon that a stage estimated; else, as a lower bound, what the curvature shows; NaN: neither.
  double epsilon = 0;
  double points_for_the_paper = 0;  ///< about so many, spread alike, would bring epsilon to 1/22; NaN: not known
  double points_for_practice = 0;   ///< ... to `good_epsilon`, where it is above; NaN: not known, or enough are there
  std::vector<WorstPlace> worst;
  std::optional<Refusal> refusal;

  const StageFigure& figure(const std::string& name) const { return figures.at(name); }
};

/// Shares of inconsistent stars. Of the samples tried, surfaces that came out right had at most 20 %, wrong ones 29 %
/// and more.
inline constexpr double good_stars = 0.05, fair_stars = 0.10, most_stars = 0.20;

/// Points are at most so far from a surface that is of some use, as a share of the diagonal.
inline constexpr double most_distance = 0.05;

/// Smoothing gave the right topology up to this sigma, as a share of the diagonal.
inline constexpr double most_noise = 0.01;

/// Everything that can be told of stages 1 to 4 as far as they came; `surface.sample` is there. `refusal`: why there is
/// no surface, if there is none. `factor`: the solver's, if one runs. O(n log n).
SampleReport make_sample_report(const Input& input, const PlacedSurface& surface, const SampleError* refusal,
                                std::optional<double> factor, std::uint64_t seed);

/// Members of the report's "sample", "surface" (of a sample that was not refused), "guarantee_of_the_paper",
/// "practice", "worst_places" and "refused"; a figure that was not measured is null, and "not_measured" says by whom.
Json to_json(const SampleReport& report);
Json to_json(const SurfaceFacts& facts);

/// A few lines: sample, stars, distance, practice, guarantee. Each begins with a word padded to 11 columns.
void print_short(const SampleReport& report, std::ostream& out);
/// Everything, with the claims of the paper and the worst places.
void print_full(const SampleReport& report, std::ostream& out);
/// "67644 of 110000 points (61.5 %), around row 5123".
std::string text_of(const SurfacePart& part);
/// One line per worst place.
std::vector<std::string> lines_of(const std::vector<WorstPlace>& worst);

}  // namespace geodrome
