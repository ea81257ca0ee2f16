// SPDX-License-Identifier: MIT
#include "geodrome/engine/pipeline.hpp"

#include <algorithm>
#include <thread>

#include "engine/input/origin.hpp"
#include "engine/surface/place.hpp"
#include "engine/surface/sample_chain.hpp"

namespace geodrome {

namespace {

PlacedSurface surface_of_mesh(const Input& input) {
  PlacedSurface surface;
  surface.made_from = InputKind::mesh;
  if (input.triangles.empty()) input::Origin(input.file).reject(InputFault::degenerate, "no face with an area is left");
  surface.mesh = std::make_shared<const SurfaceMesh>(input.positions, input.triangles, input.weights);
  for (const Index vertex : input.element_of_row) surface.places.push_back(place_of_vertex(*surface.mesh, vertex));
  return surface;
}

}  // namespace

unsigned thread_count(const RunSettings& settings) {
  return settings.threads > 0 ? settings.threads : std::max(1u, std::thread::hardware_concurrency());
}

SurfaceAttempt try_surface(const Input& input, const PluginHost& host, const RunSettings& settings,
                           Observer& observer) {
  if (input.kind == InputKind::mesh) return {surface_of_mesh(input), std::nullopt};
  return SampleChain(input, host, settings, observer).make(settings.stages);
}

PlacedSurface make_surface(const Input& input, const PluginHost& host, const RunSettings& settings,
                           Observer& observer) {
  SurfaceAttempt attempt = try_surface(input, host, settings, observer);
  if (attempt.refusal) throw *attempt.refusal;
  return std::move(attempt.surface);
}

}  // namespace geodrome
