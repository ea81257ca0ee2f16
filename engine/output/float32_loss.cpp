// SPDX-License-Identifier: MIT
#include "engine/output/float32_loss.hpp"

#include <algorithm>
#include <array>

#include "engine/formats/text.hpp"

namespace geodrome {

namespace {

using Coordinates = std::array<double, 3>;

/// The places of a mesh's vertices, equal ones with one number.
struct Places {
  std::vector<Index> of_vertex;
  Index count = 0;

  bool apart(const Triangle& t) const {
    return of_vertex[t[0]] != of_vertex[t[1]] && of_vertex[t[1]] != of_vertex[t[2]] &&
           of_vertex[t[2]] != of_vertex[t[0]];
  }
};

template <class Round>
Places places_of(std::span<const Vec3> positions, Round&& round) {
  std::vector<std::pair<Coordinates, Index>> sorted;
  for (Index v = 0; v < positions.size(); ++v)
    sorted.push_back({{round(positions[v].x), round(positions[v].y), round(positions[v].z)}, v});
  std::ranges::sort(sorted);
  Places places{std::vector<Index>(positions.size())};
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    places.count += i == 0 || sorted[i].first != sorted[i - 1].first;
    places.of_vertex[sorted[i].second] = places.count - 1;
  }
  return places;
}

}  // namespace

std::vector<Finding> float32_loss(const std::filesystem::path& file, const SurfaceMesh& mesh) {
  const Places before = places_of(mesh.positions(), [](double x) { return x; }),
               after = places_of(mesh.positions(), [](double x) { return static_cast<double>(static_cast<float>(x)); });
  if (before.count == after.count) return {};
  const auto collapsed = static_cast<std::size_t>(
      std::ranges::count_if(mesh.triangles(), [&](const Triangle& t) { return before.apart(t) && !after.apart(t); }));
  const std::size_t lost = before.count - after.count;
  return {{Finding::Severity::warning,
           "float32_loss",
           file.string() + " holds 32-bit floats, in which " + counted(lost, "vertex falls", "vertices fall") +
               " together with others and " + counted(collapsed, "face collapses", "faces collapse"),
           lost,
           {},
           "write .ply, .off or .obj with 64-bit floats, or subtract a common offset before"}};
}

}  // namespace geodrome
