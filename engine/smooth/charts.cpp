// SPDX-License-Identifier: MIT
#include "engine/smooth/charts.hpp"

#include "engine/smooth/error_estimate.hpp"

namespace geodrome {

namespace {

double mean_edge(const SurfaceMesh& mesh, Index face) {
  const auto [p, q, r] = mesh.corners(face);
  return (distance(p, q) + distance(q, r) + distance(r, p)) / 3;
}

bool has_area(const SurfaceMesh& mesh, Index face) {
  const auto [p, q, r] = mesh.corners(face);
  return squared_norm(cross(q - p, r - p)) > 0;
}

bool on_one_edge(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return (a[0] == 0 && b[0] == 0) || (a[1] == 0 && b[1] == 0) || (a[2] == 0 && b[2] == 0);
}

}  // namespace

SmoothCharts::SmoothCharts(MeshPtr mesh, std::shared_ptr<const SmoothSurface> surface)
    : mesh_(std::move(mesh)), surface_(std::move(surface)), common_(*mesh_) {
  std::vector<double> deviations;
  for (Index f = 0; f < mesh_->face_count(); ++f) {
    deviations.push_back(has_area(*mesh_, f) ? surface_->deviation(f) : infinity);
    spacing_.push_back(mean_edge(*mesh_, f));
  }
  expected_error_ = expected_errors(*mesh_, *surface_, deviations);
}

FlatPiece SmoothCharts::piece(const SurfacePoint& p, const SurfacePoint& q) const {
  FlatPiece best;
  const auto offer = [&](Index face, const std::array<double, 3>& a, const std::array<double, 3>& b) {
    const bool is_first = best.face == no_index;
    if (is_first || (trusts(face) == trusts(best.face) ? face < best.face : trusts(face)))
      best = {face, a, b, straight_within(*mesh_, face, a, b)};
  };
  // Most pieces cross a face from edge to edge, and one of their ends names it.
  for (const Index face : {p.face, q.face}) {
    const auto a = common_.on_face(p, face), b = common_.on_face(q, face);
    if (!a || !b) continue;
    offer(face, *a, *b);
    if (!on_one_edge(*a, *b)) return best;
  }
  common_.for_each_common(p, q, [&](Index face, const auto& a, const auto& b) { return offer(face, a, b), true; });
  if (best.face == no_index)
    throw NumericalError("gave a path with a step that lies in no face",
                         "choose another solver, and report this to the author of the plugin");
  return best;
}

void SmoothCharts::cut(std::span<const SurfacePoint> path, std::vector<FlatPiece>& pieces) const {
  pieces.clear();
  for (std::size_t i = 1; i < path.size(); ++i)
    if (const FlatPiece cut = piece(path[i - 1], path[i]); cut.length > 0) pieces.push_back(cut);
}

}  // namespace geodrome
