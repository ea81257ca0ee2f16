// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/view.hpp"

#include <cmath>

#include "engine/checks/seeded_subset.hpp"
#include "engine/formats/base64.hpp"
#include "engine/host/stage_context.hpp"
#include "engine/search/distances.hpp"
#include "engine/search/traced_path.hpp"
#include "engine/surface/input_rows.hpp"
#include "engine/surface/place.hpp"

namespace geodrome {

namespace {

constexpr float no_error = std::numeric_limits<float>::quiet_NaN();

std::string coordinates_text(std::span<const Vec3> points) {
  std::vector<float> values;
  values.reserve(3 * points.size());
  for (const Vec3& p : points)
    for (const double coordinate : {p.x, p.y, p.z}) values.push_back(static_cast<float>(coordinate));
  return base64_of(std::span<const float>(values));
}

Json surface_json(const SurfaceMesh& mesh) {
  const auto* corners = mesh.triangles().data();
  const std::span<const Index> indices(corners ? corners->data() : nullptr, 3 * mesh.face_count());
  return {{"positions", coordinates_text(mesh.positions())}, {"triangles", base64_of(indices)}};
}

/// The first row of the input that a vertex of the surface stands for; no_index for one that stands for none.
std::vector<Index> rows_of_vertices(const Input& input, const PlacedSurface& surface) {
  std::vector<Index> rows = rows_of_elements(input);
  if (!surface.sample) return rows;
  std::vector<Index> of_vertex;
  for (const Index element : surface.sample->sample_of_vertex)
    of_vertex.push_back(element == no_index ? no_index : rows[element]);
  return of_vertex;
}

/// D / T - 1 where both are numbers.
float error_of(double distance, double truth) {
  if (!std::isfinite(distance) || !std::isfinite(truth) || truth == 0) return no_error;
  return static_cast<float>(distance / truth - 1);
}

/// At the vertices of a surface, whose rows of the input are `rows`.
std::string errors_text(const std::vector<Index>& rows, const std::vector<double>& distances,
                        const std::vector<double>& truth) {
  std::vector<float> errors;
  for (const Index row : rows) errors.push_back(row == no_index ? no_error : error_of(distances[row], truth[row]));
  return base64_of(std::span<const float>(errors));
}

/// The distances of the vertices from a source along the surface, its start distance added; `found`: what a search
/// says, not needed for a source that lies on no surface.
std::vector<float> at_vertices(const SurfaceMesh& mesh, const NamedPoint& source, std::span<const double> found) {
  std::vector<float> distances;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    distances.push_back(static_cast<float>(
        surface_distance(source.place, place_of_vertex(mesh, v), [&] { return found[v]; }) + source.start));
  return distances;
}

}  // namespace

std::vector<std::size_t> targets_of_paths(const std::vector<double>& distances, std::size_t count, std::uint64_t seed) {
  std::vector<std::size_t> reached, chosen;
  std::size_t farthest = 0;
  for (std::size_t j = 0; j < distances.size(); ++j) {
    if (!std::isfinite(distances[j]) || distances[j] == 0) continue;
    reached.push_back(j);
    if (reached.size() == 1 || distances[j] > distances[farthest]) farthest = j;
  }
  if (reached.empty() || count == 0) return chosen;
  std::erase(reached, farthest);
  chosen.push_back(farthest);
  for (const std::size_t k : seeded_subset(reached.size(), count - 1, seed)) chosen.push_back(reached[k]);
  return chosen;
}

std::size_t ComparisonView::surface_number(const std::shared_ptr<const PlacedSurface>& surface) {
  const auto [entry, is_new] = known_.emplace(surface, surfaces_.size());
  if (is_new) surfaces_.push_back(surface_json(*surface->mesh));
  return entry->second;
}

Json ComparisonView::paths_json(const ComparedSurface& on, const Measurement& measured, std::size_t source,
                                const ShortestPathMap& map) const {
  Json json = Json::array();
  const std::vector<double>& row = measured.rows[source];
  for (const std::size_t target : targets_of_paths(row, paths_, seed_ + source)) {
    const Place& place = on.targets.named()[target].place;
    if (place.state != Place::State::on_surface) continue;
    const PathResult path = trace_path(measured.solver, map, place.at, *on.surface->mesh);
    json.push_back({{"target", target},
                    {"distance", row[target]},
                    {"length", path.length},
                    {"points", coordinates_text(path.positions)}});
  }
  return json;
}

Json ComparisonView::source_json(const ComparedSurface& on, const Measurement& measured, std::size_t source,
                                 Search& search, RunContext& context) const {
  const SurfaceMesh& mesh = *on.surface->mesh;
  const Place& place = on.sources[source].place;
  std::span<const double> found;
  Json traced = Json::array();
  if (place.state == Place::State::on_surface) {
    const bool has_paths = paths_ > 0 && measured.solver.provides(Provides::paths);
    const Source from{place.at, 0};
    const ShortestPathMap& map =
        run_search(measured.solver, search, {&from, 1},
                   {.targets = on.targets.points(), .keep = has_paths ? Keep::map : Keep::targets}, context);
    found = cross_boundary(measured.solver.plugin.info, [&] { return map.vertices(); });
    if (has_paths) traced = paths_json(on, measured, source, map);
  }
  const std::vector<float> distances = at_vertices(mesh, on.sources[source], found);
  return {{"distances", base64_of(std::span<const float>(distances))}, {"paths", std::move(traced)}};
}

void ComparisonView::add(const ComparedSurface& on, const Measurement& measured, const DistanceRows& truth,
                         Observer& observer) {
  StageContext context("view", observer, 1, seed_);
  const auto search = make_search(measured.solver);
  const std::vector<Index> rows = rows_of_vertices(input_, *on.surface);
  Json sources = Json::array();
  for (std::size_t i = 0; i < on.sources.size(); ++i) {
    sources.push_back(source_json(on, measured, i, *search, context));
    sources.back()["errors"] = errors_text(rows, measured.rows[i], truth[i]);
    context.throw_if_cancelled();
  }
  combinations_.push_back({{"surface", surface_number(on.surface)}, {"sources", std::move(sources)}});
}

}  // namespace geodrome
