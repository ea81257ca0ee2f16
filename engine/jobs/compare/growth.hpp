// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>

#include "engine/jobs/compare/combinations.hpp"
#include "engine/jobs/compare/measure.hpp"

namespace geodrome {

/// A seeded part of a sample's points, with rows of its own, the sources' points among them.
struct SamplePart {
  Input input;
  std::vector<Index> element;  ///< per row of the part: the point of the whole

  /// `sources`, of the whole, on a surface of the part.
  std::vector<NamedPoint> place(std::span<const NamedPoint> sources, const Input& whole,
                                const PlacedSurface& surface) const;
};

/// About `points` of the input's points; with the same seed a smaller part lies within a larger one, but for sources.
SamplePart part_of(const Input& input, std::size_t points, std::span<const NamedPoint> sources, std::uint64_t seed);

/// Measures what combinations cost on the same input in other sizes: a mesh with its faces cut in 4, again and again;
/// of a sample a half, a quarter, ... of the points; on the triangles, whatever the metric. Inputs and surfaces are
/// made once for all combinations.
class ComparisonGrowth {
 public:
  /// All but `levels` must outlive it. `levels` 0: no growth.
  ComparisonGrowth(unsigned levels, const Input& input, const PluginHost& host, const RunSettings& settings,
                   Observer& observer);
  ~ComparisonGrowth();

  /// Smallest first, the combination's own cost on the input among them; empty without levels. A size that cannot be
  /// measured is left out and told to the observer. Throws Cancelled.
  std::vector<GrowthStep> of(const Combination& combination, const Plugin<ShortestPathSolver>& solver,
                             const std::shared_ptr<const ComparedSurface>& on, const SearchCost& own);

 private:
  struct Sparser;

  std::shared_ptr<const ComparedSurface> finer(const std::shared_ptr<const ComparedSurface>& on, unsigned level);
  std::shared_ptr<const ComparedSurface> sparser(const StageChoice& choice, const ComparedSurface& on, unsigned level);

  unsigned levels_;
  const Input& input_;
  const PluginHost& host_;
  const RunSettings settings_;
  Observer& observer_;
  std::map<unsigned, std::shared_ptr<const ComparedSurface>> finer_;
  std::map<unsigned, std::unique_ptr<Sparser>> sparser_;
};

}  // namespace geodrome
