// SPDX-License-Identifier: MIT
#include "engine/surface/off_surface.hpp"

#include <algorithm>
#include <cmath>

#include "engine/surface/input_rows.hpp"

namespace geodrome {

namespace {

constexpr std::size_t most_told = 10;

/// The distance of the sample's farthest point from the surface; 0 for a mesh as input.
double farthest_sample_point(const Input& input, const PlacedSurface& surface) {
  double farthest = 0;
  if (surface.made_from == InputKind::points)
    for_each_live_point(input, surface, [&](Index, const Place& place) {
      farthest = std::max(farthest, distance(place.position, surface.mesh->position(place.at)));
    });
  return farthest;
}

bool could_be_rows(const Vec3& named, std::size_t rows) {
  const auto is_row = [&](double x) { return x >= 0 && x < static_cast<double>(rows) && x == std::floor(x); };
  return is_row(named.x) && is_row(named.y) && is_row(named.z);
}

}  // namespace

double surface_diagonal(const SurfaceMesh& mesh) {
  Vec3 low{infinity, infinity, infinity}, high = -low;
  for (const Triangle& triangle : mesh.triangles())
    for (const Index v : triangle) {
      const Vec3& p = mesh.positions()[v];
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  const Vec3 size = high - low;
  return mesh.face_count() == 0 ? 0 : std::hypot(size.x, size.y, size.z);
}

void OffSurfaceFinder::add(const Selection& selection, const std::vector<NamedPoint>& points) {
  if (selection.all) return;
  std::size_t at = 0;
  for (const PointEntry& entry : selection.entries) {
    add(entry, points[at], selection.file);
    at += entry.count;
  }
}

void OffSurfaceFinder::add(const PairSelection& selection, const PairList& pairs) {
  for (std::size_t i = 0; i < pairs.pairs.size(); ++i) {
    add(selection.pairs[i].from, pairs.pairs[i].from, selection.file);
    add(selection.pairs[i].to, pairs.pairs[i].to, selection.file);
  }
}

void OffSurfaceFinder::add(const PointEntry& entry, const NamedPoint& point, const std::string& file) {
  if (entry.kind != PointEntry::Kind::position) return;
  if (found_.named++ == 0) {
    found_.diagonal = surface_diagonal(*surface_.mesh);
    found_.tolerated = std::max(share_of_warning * found_.diagonal, farthest_sample_point(input_, surface_));
  }
  if (point.off_surface == 0) return;
  const Vec3 named{entry.numbers[0], entry.numbers[1], entry.numbers[2]};
  const bool as_rows = could_be_rows(named, surface_.places.size()), is_warned = point.off_surface > found_.tolerated;
  ++found_.off, found_.warned += is_warned, found_.warned_as_rows += is_warned && as_rows;
  std::vector<OffPlace>& places = found_.farthest;
  if (places.size() == most_told && places.back().distance >= point.off_surface) return;
  OffPlace place{file.empty() ? "'" + entry.label + "'" : file + ": line " + std::to_string(entry.line), named,
                 point.off_surface, as_rows};
  const auto after = std::ranges::upper_bound(places, place.distance, std::greater<>(), &OffPlace::distance);
  places.insert(after, std::move(place));
  if (places.size() > most_told) places.pop_back();
}

}  // namespace geodrome
