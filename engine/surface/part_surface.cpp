// SPDX-License-Identifier: MIT
#include "engine/surface/part_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/surface/input_rows.hpp"
#include "engine/surface/nearest_points.hpp"
#include "engine/surface/place.hpp"

namespace geodrome {

namespace {

constexpr std::size_t crowd = 8;
/// In units of the spacing. A disc of this radius has no point of a uniform random sample once in 10^12 places.
constexpr double reach_factor = 3;
constexpr double sigma_factor = 5;
/// A face is cut in four so often at most: one that is longer than 256 spacings is not shown by the sample.
constexpr int most_cuts = 8;

/// The points of the sample that the surface was made from, and how far each reaches.
class ReachingPoints {
 public:
  explicit ReachingPoints(const SampleStages& stages) : reach_of_sample(stages.control.state.size(), 0) {
    for (Index i = 0; i < reach_of_sample.size(); ++i)
      if (stages.control.state[i] != PointState::dropped)
        points_.push_back(stages.smoothed.points[i]), live.push_back(i);
    tree_ = std::make_unique<const NearestPoints>(points_);
    for (const Vec3& point : points_) {
      spacing_.push_back(spacing_at(point));
      reach_.push_back(std::max(reach_factor * spacing_.back(), sigma_factor * stages.tangents.sigma));
    }
    // A point beyond its psi is not represented by the surface, however sparse the sample is there.
    for (Index i = 0; i < live.size(); ++i) reach_of_sample[live[i]] = std::min(reach_[i], stages.control.psi[live[i]]);
  }

  /// Whether the sample shows every place of a triangle.
  bool show(const std::array<Vec3, 3>& t, int cuts = 0) const {
    const Vec3 centre = (t[0] + t[1] + t[2]) / 3;
    const Index nearest = tree_->nearest(centre, 1)[0];
    if (distance(points_[nearest], centre) > reach_[nearest]) return false;
    const double longest = std::max({distance(t[0], t[1]), distance(t[1], t[2]), distance(t[2], t[0])});
    if (longest <= reach_[nearest]) return true;
    if (cuts == most_cuts) return false;
    const Vec3 a = (t[1] + t[2]) / 2, b = (t[2] + t[0]) / 2, c = (t[0] + t[1]) / 2;
    return show({t[0], c, b}, cuts + 1) && show({c, t[1], a}, cuts + 1) && show({b, a, t[2]}, cuts + 1) &&
           show({a, b, c}, cuts + 1);
  }

  std::vector<Index> live;              ///< ascending points of the sample
  std::vector<double> reach_of_sample;  ///< how far a point may be from the surface; 0 for points that are not live

  double median_spacing() {
    const auto middle = spacing_.begin() + static_cast<std::ptrdiff_t>(spacing_.size() / 2);
    std::nth_element(spacing_.begin(), middle, spacing_.end());
    return *middle;
  }

 private:
  double spacing_at(const Vec3& point) const {
    return distance(point, points_[tree_->nearest(point, crowd + 1).back()]) * std::sqrt(std::numbers::pi / crowd);
  }

  std::vector<Vec3> points_;
  std::vector<double> reach_, spacing_;
  std::unique_ptr<const NearestPoints> tree_;
};

/// The pieces of some faces of a mesh that shared edges connect.
class Pieces {
 public:
  Pieces(const SurfaceMesh& mesh, const ReachingPoints& points) : mesh_(mesh), sets_(mesh.face_count()) {
    for (Index f = 0; f < mesh.face_count(); ++f) shown_.push_back(points.show(mesh.corners(f)));
    for (Index h = 0; h < mesh.twins().size(); ++h)
      if (const Index twin = mesh.twins()[h]; twin != no_index && shown(h / 3) && shown(twin / 3))
        sets_.unite(h / 3, twin / 3);
  }
  bool shown(Index face) const { return shown_[face]; }
  Index of(Index face) { return sets_.find(face); }

  /// The faces that are not shown, ascending.
  std::vector<Index> hidden() const {
    std::vector<Index> faces;
    for (Index f = 0; f < mesh_.face_count(); ++f)
      if (!shown_[f]) faces.push_back(f);
    return faces;
  }

 private:
  const SurfaceMesh& mesh_;
  std::vector<bool> shown_;
  detail::DisjointSets sets_;
};

/// A mesh of some faces of another, each vertex with one fan.
struct CutMesh {
  MeshPtr mesh;
  std::vector<Index> face_of;  ///< face of the other -> face; no_index: left out
  std::vector<Index> sample_of_vertex;
};

/// The corners of the faces that stay, by fans: corners of one vertex in one fan have the same root.
detail::DisjointSets fans_of(const SurfaceMesh& mesh, const std::vector<Index>& face_of) {
  detail::DisjointSets fans(3 * mesh.face_count());
  for (Index h = 0; h < 3 * mesh.face_count(); ++h) {
    const Index twin = mesh.twins()[h];
    if (twin == no_index || face_of[h / 3] == no_index || face_of[twin / 3] == no_index) continue;
    fans.unite(h, SurfaceMesh::next(twin));
    fans.unite(SurfaceMesh::next(h), twin);
  }
  return fans;
}

CutMesh cut(const SurfaceMesh& mesh, const std::vector<Index>& faces, const std::vector<Index>& sample_of_vertex) {
  CutMesh result;
  result.face_of.assign(mesh.face_count(), no_index);
  for (Index k = 0; k < faces.size(); ++k) result.face_of[faces[k]] = k;
  detail::DisjointSets fans = fans_of(mesh, result.face_of);
  std::vector<Index> vertex_of(3 * mesh.face_count(), no_index);
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  for (const Index face : faces) {
    Triangle& triangle = triangles.emplace_back();
    for (Index i = 0; i < 3; ++i) {
      Index& vertex = vertex_of[fans.find(3 * face + i)];
      const Index old = mesh.triangles()[face][i];
      if (vertex == no_index) {
        vertex = static_cast<Index>(positions.size());
        positions.push_back(mesh.positions()[old]);
        result.sample_of_vertex.push_back(sample_of_vertex[old]);
      }
      triangle[i] = vertex;
    }
  }
  result.mesh = std::make_shared<const SurfaceMesh>(std::move(positions), std::move(triangles));
  return result;
}

/// The closest place of every live point on the faces that are shown, and its piece; none beyond its reach.
struct Nearness {
  std::vector<SurfacePoint> at;
  std::vector<Index> piece;
  Index largest = no_index;  ///< the piece with most points
};

Nearness near_pieces(const Input& input, const PlacedSurface& surface, const ReachingPoints& points, Pieces& pieces) {
  const std::vector<Index> hidden = pieces.hidden();
  Nearness result;
  std::vector<std::size_t> count(surface.mesh->face_count(), 0);
  for (const Index i : points.live) {
    const ClosestPoint found = surface.locator->closest(input.positions[i], hidden);
    const bool reached = found.at.face != no_index && found.distance <= points.reach_of_sample[i];
    result.at.push_back(found.at);
    result.piece.push_back(reached ? pieces.of(found.at.face) : no_index);
    if (reached) ++count[result.piece.back()];
  }
  const auto most = std::ranges::max_element(count);
  if (most != count.end() && *most > 0) result.largest = static_cast<Index>(most - count.begin());
  return result;
}

/// The place of every point of the input, and how many are where.
std::vector<Place> places_on(const Input& input, const CutMesh& made, const ReachingPoints& points,
                             const Nearness& nearness, SurfacePart& part) {
  std::vector<Place> places;
  for (const Vec3& position : input.positions) places.push_back({Place::State::off_part, {}, no_index, position});
  for (Index k = 0; k < points.live.size(); ++k) {
    const Index i = points.live[k], piece = nearness.piece[k];
    if (piece != nearness.largest) {
      ++(piece == no_index ? part.off_surface : part.other_pieces);
      continue;
    }
    const SurfacePoint at{made.face_of[nearness.at[k].face], nearness.at[k].b};
    places[i] = place_on(*made.mesh, at, input.positions[i]);
    ++part.points;
  }
  part.no_surface = part.sample - points.live.size();
  return places;
}

/// The row on the part that is nearest to the mean of the points on it.
Index row_in_the_middle(const Input& input, const std::vector<Place>& places) {
  const std::vector<Index> row_of = rows_of_elements(input);
  Vec3 sum;
  double count = 0;
  for (const Place& place : places)
    if (place.state == Place::State::on_surface) sum = sum + (place.position - input.positions[0]), ++count;
  const Vec3 middle = input.positions[0] + sum / count;
  Index best = no_index;
  for (Index i = 0; i < places.size(); ++i) {
    if (places[i].state != Place::State::on_surface) continue;
    if (best == no_index || distance(input.positions[i], middle) < distance(input.positions[best], middle)) best = i;
  }
  return row_of[best];
}

void take(PlacedSurface& surface, CutMesh made) {
  surface.mesh = std::move(made.mesh);
  surface.locator = std::make_shared<const SurfaceLocator>(surface.mesh);
  surface.sample->sample_of_vertex = std::move(made.sample_of_vertex);
  surface.inserter.reset();
  // What was said of the boundary and the components of the surface that was cut is no longer so.
  std::erase_if(surface.findings, [](const Finding& f) { return f.code == "components" || f.code == "boundary"; });
  if (!surface.mesh->closed())
    surface.findings.push_back({Finding::Severity::warning,
                                "boundary",
                                "the part has a boundary, where the sample shows no more of the surface.",
                                1,
                                {},
                                {}});
}

}  // namespace

bool cut_to_part(const Input& input, PlacedSurface& surface) {
  ReachingPoints points(*surface.sample);
  Pieces pieces(*surface.mesh, points);
  const Nearness nearness = near_pieces(input, surface, points, pieces);
  if (nearness.largest == no_index) return false;
  std::vector<Index> faces;
  for (Index f = 0; f < surface.mesh->face_count(); ++f)
    if (pieces.shown(f) && pieces.of(f) == nearness.largest) faces.push_back(f);
  SurfacePart part{.sample = input.positions.size()};
  part.faces_left_out = pieces.hidden().size();
  const bool whole = faces.size() == surface.mesh->face_count();
  CutMesh made = whole ? CutMesh{surface.mesh, faces, surface.sample->sample_of_vertex}
                       : cut(*surface.mesh, faces, surface.sample->sample_of_vertex);
  const std::vector<Place> places = places_on(input, made, points, nearness, part);
  part.spacing = points.median_spacing();
  part.row = row_in_the_middle(input, places);
  for (const Index sample : made.sample_of_vertex)
    part.reach.push_back(sample == no_index ? 0 : points.reach_of_sample[sample]);
  surface.places.clear();
  for (const Index i : input.element_of_row) surface.places.push_back(i == no_index ? Place{} : places[i]);
  surface.part = std::move(part);
  if (!whole) take(surface, std::move(made));
  return true;
}

bool within_reach(const PlacedSurface& surface, const SurfacePoint& at, const Vec3& position) {
  double reach = 0;
  for (const Index vertex : surface.mesh->triangles()[at.face]) reach = std::max(reach, surface.part->reach[vertex]);
  return distance(surface.mesh->position(at), position) <= reach;
}

}  // namespace geodrome
