// SPDX-License-Identifier: MIT
#include "engine/checks/path_audit.hpp"

#include <cmath>

#include "engine/checks/invariants.hpp"
#include "engine/checks/rounding_scale.hpp"
#include "engine/formats/number_text.hpp"
#include "engine/search/smooth_distances.hpp"
#include "engine/surface/common_face.hpp"

namespace geodrome {

namespace {

/// The length of the way through common faces from one end to the other; +inf where a step lies in no face.
double walked(const SurfaceMesh& mesh, const SurfacePoint& from, const PathResult& path, const SurfacePoint& to) {
  const CommonFace common(mesh);
  double length = 0;
  const SurfacePoint* before = &from;
  const auto step = [&](const SurfacePoint& next) {
    length += common.straight(*before, next).value_or(infinity);
    before = &next;
  };
  for (const SurfacePoint& point : path.points) step(point);
  step(to);
  return length;
}

/// The distance by a search from the other end; nothing where the solver cannot search so or promises no factor.
std::optional<double> searched_back(const PreparedSolver& solver, const Place& from, const Place& to,
                                    RunContext& context) {
  const bool possible = solver.takes_source_at(to) && solver.answers_at(from);
  const bool promised =
      std::isfinite(solver.plugin.factor) && solver.states_factor_at(from) && solver.states_factor_at(to);
  if (!possible || !promised) return std::nullopt;
  return searched_distance(solver, *make_search(solver), to, from, context);
}

}  // namespace

std::vector<std::string> audit_path(const PreparedSolver& solver, const SurfaceMesh& mesh, const NamedPoint& from,
                                    const TargetList& to, const PathResult& path, RunContext& context) {
  std::vector<std::string> broken;
  const NamedPoint& end = to.named()[0];
  if (from.place.state != Place::State::on_surface || end.place.state != Place::State::on_surface) return broken;
  const double scale = RoundingScale().distances({&path.distance, 1}).points(mesh.positions()).value();
  const double slack = float64_tolerance * scale;
  const auto differ = [&](const std::string& a, double x, const std::string& b, double y) {
    broken.push_back(a + " is " + number_text(x) + ", but " + b + " " + number_text(y));
  };
  if (std::isfinite(path.distance)) {
    const double length = walked(mesh, from.place.at, path, end.place.at);
    if (path.points.empty() || !(std::abs(length - path.length) <= slack))
      differ("the path's length", path.length, "on the surface, from end to end, it has", length);
    // Of a cloud the straight line may be longer than the way along the estimated surface.
    const double along =
        to.bounded() ? std::max(path.length, distance(from.place.position, end.place.position)) : path.length;
    if (solver.provides(Provides::path_is_distance) && !(std::abs(along - path.distance) <= slack))
      differ("the distance", path.distance, "the path has", along);
  }
  if (const auto back = searched_back(solver, from.place, end.place, context)) {
    const double factor = solver.plugin.factor, ruled = DistanceRule{to.bounded()}(*back, from, end);
    const bool same = std::isfinite(ruled) == std::isfinite(path.distance);
    if (!same || path.distance - factor * ruled > slack || ruled - factor * path.distance > slack)
      differ("the distance", path.distance, "from the other end it is", ruled);
  }
  return broken;
}

std::vector<std::string> audit_smooth_path(const PreparedSolver& solver, const SurfaceMesh& mesh,
                                           const NamedPoint& from, const TargetList& to, const PathResult& path,
                                           RunContext& context) {
  PathResult flat = shortest_path(solver, mesh, from, to, context);
  std::vector<std::string> broken = audit_path(solver, mesh, from, to, flat, context);
  smooth_path(solver, from, to, flat);
  if (flat.distance != path.distance || flat.length != path.length || flat.points != path.points)
    broken.push_back("the path's length is " + number_text(path.length) + ", its distance " +
                     number_text(path.distance) + ", but made again " + number_text(flat.length) + ", " +
                     number_text(flat.distance));
  return broken;
}

}  // namespace geodrome
