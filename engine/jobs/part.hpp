// SPDX-License-Identifier: MIT
#pragma once

#include "engine/report/sample_report.hpp"
#include "geodrome/engine/pipeline.hpp"

namespace geodrome {

/// A part of a sample that makes a surface by itself, and the report on it.
struct FoundPart {
  PlacedSurface surface;  ///< with `part`
  SampleReport report;
};

/// The largest part found that the stages make a surface of and that is as good as a whole sample has to be: nothing
/// refused, at most 5 % of the points off the surface, and experience does not call it doubtful. Tried are the whole
/// sample, if `whole` is not refused, and the candidates of `part_candidates`, each cut by `cut_to_part`; none where
/// there are too few points. Throws what the stages throw, but for SampleError. Complexity: stages 1 to 4, up to five
/// times.
std::optional<FoundPart> find_part(const Input& input, const SurfaceAttempt& whole, const PluginHost& host,
                                   const RunSettings& settings, std::optional<double> factor, Observer& observer);

/// Whether candidates are looked for: stage 1 gave planes, and there are enough points for a part.
bool has_candidates(const SurfaceAttempt& whole);

/// The refusal of a whole sample that has candidates, with what can be had of it.
SampleError with_part(const SampleError& refusal, const std::optional<FoundPart>& found);

/// The refusal of a sample whose stages make a surface, on which `report` is, but that has no part as it was asked for.
SampleError without_part(const SampleReport& report);

}  // namespace geodrome
