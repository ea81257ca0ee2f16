// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/surfaces.hpp"

#include "engine/input/finding_text.hpp"
#include "engine/surface/smooth_fit.hpp"
#include "geodrome/engine/named_points.hpp"

namespace geodrome {

namespace {

/// Combinations with the same key share their surface.
std::string key_of(const StageChoice& choice, InputKind kind) {
  if (kind == InputKind::mesh) return {};
  return choice.tangent + "\n" + choice.control + "\n" + choice.decimator + "\n" + choice.reconstructor;
}

}  // namespace

ComparedSurfaces::ComparedSurfaces(const Input& input, const PluginHost& host, const RunSettings& settings,
                                   Observer& observer, PlaceSources place)
    : input_(input),
      host_(host),
      settings_(settings),
      observer_(observer),
      place_(std::move(place)),
      chain_(input, host, settings, observer) {}

SurfaceAttempt ComparedSurfaces::attempt(const StageChoice& choice) {
  if (input_.kind == InputKind::points) return chain_.make(choice);
  return try_surface(input_, host_, settings_, observer_);
}

void ComparedSurfaces::add_smooth(PlacedSurface& surface, const StageChoice& choice) const {
  RunSettings chosen = settings_;
  chosen.stages = choice;
  surface.smooth = fit_smooth(surface, {input_.positions}, host_, chosen, observer_);
  settle_places(surface);
}

std::shared_ptr<const PlacedSurface> ComparedSurfaces::make(const StageChoice& choice) {
  const std::string key = key_of(choice, input_.kind);
  if (const auto known = surfaces_.find(key); known != surfaces_.end()) return known->second;
  SurfaceAttempt made = attempt(choice);
  if (made.refusal) throw *made.refusal;
  if (settings_.metric == Metric::smooth) add_smooth(made.surface, choice);
  for (const Finding& finding : made.surface.findings)
    if (finding.severity == Finding::Severity::warning) observer_.log(LogLevel::warning, text_of(finding, observer_));
  return surfaces_[key] = std::make_shared<const PlacedSurface>(std::move(made.surface));
}

std::shared_ptr<const ComparedSurface> ComparedSurfaces::placed(const std::shared_ptr<const PlacedSurface>& surface) {
  std::shared_ptr<const ComparedSurface>& known = placed_[surface];
  if (known) return known;
  TargetList targets(select("all", input_, *surface), *surface);
  known = std::make_shared<const ComparedSurface>(
      ComparedSurface{surface, place_(*surface), std::move(targets), metric_of(*surface)});
  return known;
}

}  // namespace geodrome
