// SPDX-License-Identifier: MIT
#include "tools/bench/samples/file_samples.hpp"

#include <cstdio>
#include <ostream>

#include "engine/surface/off_surface.hpp"
#include "tools/bench/samples/hausdorff.hpp"
#include "tools/bench/samples/sample_case.hpp"

namespace geodrome::bench {
namespace {

constexpr std::size_t gap_samples = 200'000;

/// The file's own surface; null if it has no faces.
MeshPtr reference_of(const std::filesystem::path& file, const ReadOptions& options) {
  Input input = read_input(file, options);
  if (input.triangles.empty()) return nullptr;
  return std::make_shared<const SurfaceMesh>(std::move(input.positions), std::move(input.triangles));
}

void print_gap(std::ostream& out, const MeshPtr& reference, const MeshPtr& made, std::uint64_t seed) {
  const double diagonal = surface_diagonal(*reference);
  const SurfaceGap there = surface_gap(reference, made, gap_samples, seed);
  const SurfaceGap back = surface_gap(made, reference, gap_samples, seed);
  char text[300];
  std::snprintf(text, sizeof text,
                "    gap over the diagonal: file to result %.3g (mean %.3g), result to file %.3g (mean %.3g)\n",
                there.largest / diagonal, there.mean / diagonal, back.largest / diagonal, back.mean / diagonal);
  out << text;
}

bool same_topology(const SurfaceFacts& a, const SurfaceFacts& b) {
  return a.components == b.components && a.boundary_loops == b.boundary_loops && a.genus == b.genus;
}

void print_file(std::ostream& out, const std::filesystem::path& file, const PluginHost& host,
                const RunSettings& settings) {
  const MeshPtr reference = reference_of(file, settings.read);
  ReadOptions as_points = settings.read;
  as_points.as = InputKind::points;
  const Input input = read_input(file, as_points);
  const SampleResult result = run_sample(input, host, settings, {});
  char text[120];
  std::snprintf(text, sizeof text, ": %zu points, %.3f s\n", input.positions.size(), result.seconds);
  out << file.filename().string() << text;
  const SurfaceFacts wanted = reference ? facts_of(*reference) : SurfaceFacts{};
  if (reference) out << "    file:   " << text_of(wanted) << '\n';
  if (!result.surface) {
    out << (result.outcome == Outcome::refused ? "    refused: " : "    failed: ") << result.reason << '\n';
    return;
  }
  out << "    result: " << text_of(*result.facts) << ", " << result.facts->vertices << " vertices"
      << (!reference                             ? ""
          : same_topology(wanted, *result.facts) ? ": as the file"
                                                 : ": not as the file")
      << '\n';
  if (reference) print_gap(out, reference, result.surface->mesh, settings.seed);
}

}  // namespace

void print_file_samples(std::ostream& out, const std::vector<std::filesystem::path>& files, const PluginHost& host,
                        const RunSettings& settings) {
  for (const auto& file : files) {
    try {
      print_file(out, file, host, settings);
    } catch (const InputError& error) {
      out << file.filename().string() << "\n    not read: " << error.what() << '\n';
    }
    out << std::flush;
  }
}

}  // namespace geodrome::bench
