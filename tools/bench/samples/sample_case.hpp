// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/checks/surface_facts.hpp"
#include "geodrome/engine/pipeline.hpp"
#include "geodrome/engine/plugin_host.hpp"
#include "tools/bench/samples/sheet_errors.hpp"

namespace geodrome::bench {

/// One sample of a known shape.
struct SampleCase {
  std::string shape, sampling;  ///< sampling: uniform, blue, grid (exact lattice), jittered (lattice, moved by 1e-7)
                                ///< or loose (lattice, moved by up to 0.3 of a step)
  std::size_t points = 0;
  std::uint64_t seed = 1;
  double noise = 0, outliers = 0;  ///< shares of the diagonal and of the number of points
  std::string boundary;            ///< the reconstructor's option; empty: its default
};

/// What the surface of a sampled shape must be; one component.
struct Topology {
  long genus = 0;
  std::size_t loops = 0;
};

/// Throws OptionError for a shape whose surface is not listed.
Topology expected_topology(const std::string& shape);

enum class Outcome {
  right,
  refused,  ///< SampleError
  wrong,    ///< a surface, but not the one that was sampled
  failed    ///< any other error: always a fault
};

/// What became of a sample. `reason`: of a refusal or failure, or how the surface differs.
struct SampleResult {
  Outcome outcome = Outcome::failed;
  double seconds = 0;  ///< of stages 1 to 4 and the projection of all points
  std::string reason;
  std::optional<SurfaceFacts> facts;  ///< of the surface, if there is one
  std::optional<PlacedSurface> surface;
  std::optional<SheetErrors> sheet;  ///< of a shape that can be unrolled, if there is a surface
};

/// Throws OptionError for an unknown shape or sampling.
PointSample make_sample(const SampleCase& wanted);

/// Points as the engine reads them from a file without flaws. Precondition: finite and pairwise distinct.
Input input_of(PointSample sample);

/// Stages 1 to 4. What the engine throws is an outcome, except OptionError. Without `expected` any surface is right.
SampleResult run_sample(const Input& input, const PluginHost& host, const RunSettings& settings,
                        const std::optional<Topology>& expected);

/// The result of a case: its sample through stages 1 to 4, and of sheets the distances.
SampleResult run_case(const SampleCase& wanted, const PluginHost& host, RunSettings settings);

/// "genus 1, 1 component, 0 boundary loops".
std::string text_of(const SurfaceFacts& facts);

}  // namespace geodrome::bench
