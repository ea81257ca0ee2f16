// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "engine/search/target_list.hpp"
#include "engine/surface/sample_chain.hpp"

namespace geodrome {

/// A surface of a comparison, and where sources and targets lie on it.
struct ComparedSurface {
  std::shared_ptr<const PlacedSurface> surface;
  std::vector<NamedPoint> sources;
  TargetList targets;                                    ///< all rows of the input
  std::shared_ptr<const SmoothMetric> metric = nullptr;  ///< if the smooth surface is measured on too
};

/// The surfaces that combinations make of one input, each made once, with what is smooth over them if the settings'
/// metric is.
class ComparedSurfaces {
 public:
  using PlaceSources = std::function<std::vector<NamedPoint>(const PlacedSurface&)>;

  /// All must outlive it; `place` finds the sources on a surface.
  ComparedSurfaces(const Input& input, const PluginHost& host, const RunSettings& settings, Observer& observer,
                   PlaceSources place);

  /// The surface by the sample stages of `choice`; of a mesh the same for all. Tells the observer its warnings, once.
  /// Throws what the stages throw, and as `fit_smooth`.
  std::shared_ptr<const PlacedSurface> make(const StageChoice& choice);

  /// The places on a surface of `make`. Throws what `place` throws.
  std::shared_ptr<const ComparedSurface> placed(const std::shared_ptr<const PlacedSurface>& surface);

 private:
  SurfaceAttempt attempt(const StageChoice& choice);
  void add_smooth(PlacedSurface& surface, const StageChoice& choice) const;

  const Input& input_;
  const PluginHost& host_;
  const RunSettings& settings_;
  Observer& observer_;
  PlaceSources place_;
  SampleChain chain_;
  std::map<std::string, std::shared_ptr<const PlacedSurface>> surfaces_;  // by the choices of the sample stages
  std::map<std::shared_ptr<const PlacedSurface>, std::shared_ptr<const ComparedSurface>> placed_;
};

}  // namespace geodrome
