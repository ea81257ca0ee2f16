// SPDX-License-Identifier: MIT
#include "engine/output/float32_loss.hpp"

#include <algorithm>
#include <array>

#include "engine/formats/text.hpp"
#include "engine/formats/text_stream.hpp"

namespace geodrome {

namespace {

/// Moves up to this share of an edge are noise that no distance shows.
constexpr double small_share = 0.025;

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

double as_float32(double x) { return static_cast<double>(static_cast<float>(x)); }

/// The largest distance by which rounding to float32 moves a vertex.
double largest_move(const SurfaceMesh& mesh) {
  double largest = 0;
  for (const Vec3& p : mesh.positions())
    largest = std::max(largest, distance(p, {as_float32(p.x), as_float32(p.y), as_float32(p.z)}));
  return largest;
}

double median_edge(const SurfaceMesh& mesh) {
  std::vector<double> lengths;
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (std::size_t i = 0; i < 3; ++i) lengths.push_back(distance(mesh.corners(f)[i], mesh.corners(f)[(i + 1) % 3]));
  if (lengths.empty()) return 0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::ranges::nth_element(lengths, middle);
  return *middle;
}

std::string move_text(double moved, double edge) {
  TextOutput text;
  text.precision(3);
  text << "by up to " << moved << ", " << 100 * moved / edge << " % of the median edge";
  return text.str();
}

}  // namespace

std::vector<Finding> float32_loss(const std::filesystem::path& file, const SurfaceMesh& mesh) {
  const Places before = places_of(mesh.positions(), [](double x) { return x; }),
               after = places_of(mesh.positions(), as_float32);
  const double moved = largest_move(mesh), edge = median_edge(mesh);
  const std::size_t lost = before.count - after.count;
  if (lost == 0 && !(moved > small_share * edge)) return {};
  const auto collapsed = static_cast<std::size_t>(
      std::ranges::count_if(mesh.triangles(), [&](const Triangle& t) { return before.apart(t) && !after.apart(t); }));
  std::string message = file.string() + " holds 32-bit floats, which move vertices " + move_text(moved, edge);
  if (lost > 0)
    message += "; " + counted(lost, "vertex falls", "vertices fall") + " together with others and " +
               counted(collapsed, "face collapses", "faces collapse");
  return {{Finding::Severity::warning,
           "float32_loss",
           message,
           lost > 0 ? lost : mesh.vertex_count(),
           {},
           "write .ply, .off or .obj with 64-bit floats, or subtract a common offset before"}};
}

}  // namespace geodrome
