// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/view.hpp"

#include <cmath>

#include "engine/checks/seeded_subset.hpp"
#include "engine/formats/base64.hpp"
#include "engine/host/stage_context.hpp"
#include "engine/search/traced_path.hpp"
#include "engine/surface/input_rows.hpp"

namespace geodrome {

namespace {

constexpr float not_computed = std::numeric_limits<float>::quiet_NaN();

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
  if (!std::isfinite(distance) || !std::isfinite(truth) || truth == 0) return not_computed;
  return static_cast<float>(distance / truth - 1);
}

/// At the vertices of a surface, whose rows of the input are `rows`.
std::string errors_text(const std::vector<Index>& rows, const std::vector<double>& distances,
                        const std::vector<double>& truth) {
  std::vector<float> errors;
  for (const Index row : rows) errors.push_back(row == no_index ? not_computed : error_of(distances[row], truth[row]));
  return base64_of(std::span<const float>(errors));
}

/// The distances at the vertices from a source that no search starts from.
std::vector<float> without_search(const NamedPoint& source, std::size_t vertices) {
  const bool isolated = source.place.state == Place::State::isolated;
  std::vector<float> values(vertices, isolated ? std::numeric_limits<float>::infinity() : not_computed);
  if (isolated) values[source.place.vertex] = static_cast<float>(source.start);
  return values;
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
    const Place& place = on.targets.queries()[target].place;
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
  const std::size_t vertices = on.surface->mesh->vertex_count();
  const NamedPoint& query = on.sources[source];
  std::vector<float> distances = without_search(query, vertices);
  Json traced = Json::array();
  if (query.place.state == Place::State::on_surface) {
    const bool has_paths = paths_ > 0 && measured.solver.provides(Provides::paths);
    const Source from{query.place.at, 0};
    const ShortestPathMap& map =
        run_search(measured.solver, search, {&from, 1},
                   {.targets = on.targets.points(), .keep = has_paths ? Keep::map : Keep::targets}, context);
    const auto values = cross_boundary(measured.solver.plugin.info, [&] { return map.vertices(); });
    for (std::size_t v = 0; v < vertices; ++v) distances[v] = static_cast<float>(values[v] + query.start);
    if (has_paths) traced = paths_json(on, measured, source, map);
  }
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
