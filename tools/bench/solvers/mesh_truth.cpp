// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/mesh_truth.hpp"

#include <algorithm>

#include "tools/bench/samples/distance_errors.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::bench {
namespace {

using Matrix = std::vector<std::vector<double>>;

constexpr double most_seconds = 3600;  // seconds for one search; none is expected to hang

Matrix extrapolated(const Matrix& coarse, const Matrix& fine, double coarse_faces, double fine_faces) {
  Matrix limit = fine;
  for (std::size_t i = 0; i < fine.size(); ++i)
    for (std::size_t j = 0; j < fine[i].size(); ++j)
      limit[i][j] = bench::extrapolated(coarse[i][j], fine[i][j], coarse_faces, fine_faces);
  return limit;
}

}  // namespace

double extrapolated(double coarse, double fine, double coarse_faces, double fine_faces) {
  return fine + (fine - coarse) / (fine_faces / coarse_faces - 1);
}

MeshTruth::MeshTruth(const std::string& shape, std::size_t faces, const Plugin<ShortestPathSolver>& solver) {
  std::size_t wanted = faces / 16;
  for (Level& level : levels_) {
    level.mesh = std::make_shared<const SurfaceMesh>(shapes::mesh(shape, wanted));
    level.locator = std::make_unique<SurfaceLocator>(level.mesh);
    level.solver = std::make_unique<Witness>(solver, level.mesh, most_seconds);
    wanted *= 4;
  }
}

Matrix MeshTruth::on_level(Level& level, std::span<const Vec3> points, std::span<const Index> sources) {
  std::vector<SurfacePoint> places;
  for (const Vec3& p : points) places.push_back(level.locator->closest(p).at);
  Matrix rows;
  for (const Index source : sources) {
    const Source start{places[source]};
    level.solver->run({&start, 1}, {.targets = places, .keep = Keep::targets});
    rows.push_back(level.solver->at(places));
  }
  return rows;
}

TrueDistances MeshTruth::distances(std::span<const Vec3> points, std::span<const Index> sources) {
  std::array<Matrix, 3> on;
  for (std::size_t i = 0; i < on.size(); ++i) on[i] = on_level(levels_[i], points, sources);
  const Matrix rough = extrapolated(on[0], on[1], levels_[0].faces(), levels_[1].faces());
  TrueDistances truth{extrapolated(on[1], on[2], levels_[1].faces(), levels_[2].faces())};
  const DistanceErrors errors = distance_errors(truth.from, rough);
  truth.mean_error = errors.far.mean;
  truth.largest_error = std::max(errors.far.largest_over, errors.far.largest_under);
  return truth;
}

}  // namespace geodrome::bench
