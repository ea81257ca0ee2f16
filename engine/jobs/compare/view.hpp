// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include "engine/report/json.hpp"
#include "engine/jobs/compare/measure.hpp"

namespace geodrome {

/// The data that the page of a comparison shows in space: surfaces, distances and errors at their vertices, paths;
/// arrays as base64 of little-endian float32 and uint32.
class ComparisonView {
 public:
  /// `input` must outlive it. `paths`: per source to its farthest target and seeded others.
  ComparisonView(const Input& input, unsigned paths, std::uint64_t seed) : input_(input), paths_(paths), seed_(seed) {}

  /// A combination that ran; searches from every source once more. Throws what the solver throws.
  void add(const ComparedSurface& on, const Measurement& measured, const DistanceRows& truth, Observer& observer);
  void add_failed() { combinations_.push_back(nullptr); }

  Json json() const { return {{"surfaces", surfaces_}, {"combinations", combinations_}}; }

 private:
  std::size_t surface_number(const std::shared_ptr<const PlacedSurface>& surface);
  Json source_json(const ComparedSurface& on, const Measurement& measured, std::size_t source, Search& search,
                   RunContext& context) const;
  Json paths_json(const ComparedSurface& on, const Measurement& measured, std::size_t source,
                  const ShortestPathMap& map) const;

  const Input& input_;
  unsigned paths_;
  std::uint64_t seed_;
  std::map<std::shared_ptr<const PlacedSurface>, std::size_t> known_;
  Json surfaces_ = Json::array(), combinations_ = Json::array();
};

/// The targets of paths: the farthest that has a finite distance, the lowest row in a tie, then seeded others above 0.
std::vector<std::size_t> targets_of_paths(const std::vector<double>& distances, std::size_t count, std::uint64_t seed);

}  // namespace geodrome
