// SPDX-License-Identifier: MIT
#include "tools/bench/samples/sample_case.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <numeric>

#include "geodrome/engine/observer.hpp"
#include "tools/bench/samples/disturb.hpp"
#include "tools/shapes/shapes.hpp"
#include "tools/shapes/sheets.hpp"

namespace geodrome::bench {
namespace {

/// Far above rounding, far below the spacing of any sample here: what was cocircular no longer is.
constexpr double jitter = 1e-7;

/// Outliers and jitter must not repeat the numbers that the shape was drawn with.
constexpr std::uint64_t disturbing = 0x6f75746c;

shapes::Sampling sampling_of(const std::string& word) {
  if (word == "uniform") return shapes::Sampling::uniform;
  if (word == "blue") return shapes::Sampling::blue;
  if (word == "grid" || word == "jittered" || word == "loose") return shapes::Sampling::grid;
  throw OptionError("unknown sampling '" + word + "'", "valid: uniform, blue, grid, jittered, loose");
}

std::string how_wrong(const SurfaceFacts& facts, const Topology& expected) {
  const bool right = facts.manifold && facts.oriented && facts.components == 1 && facts.genus == expected.genus &&
                     facts.boundary_loops == expected.loops;
  return right ? std::string() : text_of(facts);
}

std::string with_option(const std::string& selection, const std::string& option) {
  return selection + (selection.find(':') == std::string::npos ? ":" : ",") + option;
}

}  // namespace

Topology expected_topology(const std::string& shape) {
  static const std::map<std::string, Topology> known{
      {"sphere", {0, 0}},  {"ellipsoid", {0, 0}},  {"torus", {1, 0}},   {"genus2", {2, 0}},     {"genus5", {5, 0}},
      {"trefoil", {1, 0}}, {"bumpy", {0, 0}},      {"star", {0, 0}},    {"cut-sphere", {0, 1}}, {"cut-torus", {0, 2}},
      {"plane", {0, 1}},   {"swiss-roll", {0, 1}}, {"s-curve", {0, 1}}, {"slit-pipe", {0, 1}}};
  const auto found = known.find(shape);
  if (found != known.end()) return found->second;
  std::string valid;
  for (const auto& [name, topology] : known) valid += (valid.empty() ? "" : ", ") + name;
  throw OptionError("unknown shape '" + shape + "'", "valid: " + valid);
}

PointSample make_sample(const SampleCase& wanted) {
  const double jitter_of_steps = wanted.sampling == "loose" ? 0.3 : 0;
  PointSample sample = shapes::sample(
      wanted.shape, {wanted.points, sampling_of(wanted.sampling), wanted.noise, wanted.seed, jitter_of_steps});
  if (wanted.sampling == "jittered") sample = jittered(std::move(sample), jitter, wanted.seed ^ disturbing);
  if (wanted.outliers > 0) sample = with_outliers(std::move(sample), wanted.outliers, wanted.seed ^ disturbing);
  return sample;
}

Input input_of(PointSample sample) {
  Input input;
  input.kind = InputKind::points;
  input.positions = std::move(sample.points);
  input.element_of_row.resize(input.positions.size());
  std::iota(input.element_of_row.begin(), input.element_of_row.end(), Index{0});
  input.facts.rows = input.positions.size();
  return input;
}

SampleResult run_sample(const Input& input, const PluginHost& host, const RunSettings& settings,
                        const std::optional<Topology>& expected) {
  SampleResult result;
  Observer silent;
  const auto start = std::chrono::steady_clock::now();
  try {
    result.surface = make_surface(input, host, settings, silent);
  } catch (const OptionError&) {
    throw;
  } catch (const SampleError& error) {
    result.outcome = Outcome::refused, result.reason = error.what();
  } catch (const Error& error) {
    result.reason = error.what();
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!result.surface) return result;
  result.facts = facts_of(*result.surface->mesh);
  if (expected) result.reason = how_wrong(*result.facts, *expected);
  result.outcome = result.reason.empty() ? Outcome::right : Outcome::wrong;
  return result;
}

SampleResult run_case(const SampleCase& wanted, const PluginHost& host, RunSettings settings) {
  if (!wanted.boundary.empty())
    settings.stages.reconstructor = with_option(settings.stages.reconstructor, "boundary=" + wanted.boundary);
  settings.seed = wanted.seed;
  const PointSample sample = make_sample(wanted);
  SampleResult result = run_sample(input_of(sample), host, settings, expected_topology(wanted.shape));
  if (!result.surface || std::ranges::count(shapes::sheet_kinds(), wanted.shape) == 0) return result;
  result.sheet = sheet_errors(wanted.shape, sample, *result.surface, host, wanted.seed);
  if (result.outcome == Outcome::right) result.reason = how_wrong(*result.sheet);
  result.outcome = result.reason.empty() ? Outcome::right : Outcome::wrong;
  return result;
}

std::string text_of(const SurfaceFacts& facts) {
  const auto plural = [](std::size_t count, const char* word) {
    return std::to_string(count) + " " + word + (count == 1 ? "" : "s");
  };
  return (facts.genus ? "genus " + std::to_string(*facts.genus) : std::string("no genus")) + ", " +
         plural(facts.components, "component") + ", " + plural(facts.boundary_loops, "boundary loop") +
         (facts.manifold ? "" : ", not manifold") + (facts.oriented ? "" : ", not oriented");
}

}  // namespace geodrome::bench
