// SPDX-License-Identifier: MIT
#include "tools/bench/samples/hausdorff.hpp"

#include <algorithm>
#include <cmath>

#include "geodrome/engine/surface_locator.hpp"
#include "tools/shapes/random.hpp"

namespace geodrome::bench {
namespace {

/// Draws points of a mesh uniformly by area.
class AreaSampler {
 public:
  explicit AreaSampler(const SurfaceMesh& mesh) : mesh_(mesh) {
    double sum = 0;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const auto [p, q, r] = mesh.corners(f);
      areas_.push_back(sum += norm(cross(q - p, r - p)));
    }
  }

  Vec3 draw(shapes::Random& random) const {
    const double wanted = random.uniform() * areas_.back();
    const auto face = std::upper_bound(areas_.begin(), areas_.end() - 1, wanted) - areas_.begin();
    // The square root makes the density even over the triangle (Turk 1990).
    const double root = std::sqrt(random.uniform()), along = random.uniform();
    return mesh_.position({static_cast<Index>(face), {1 - root, root * (1 - along), root * along}});
  }

 private:
  const SurfaceMesh& mesh_;
  std::vector<double> areas_;  ///< twice the area of all faces up to this one
};

}  // namespace

SurfaceGap surface_gap(const MeshPtr& from, const MeshPtr& to, std::size_t samples, std::uint64_t seed) {
  if (from->face_count() == 0) throw InputError(InputFault::empty, "the mesh has no face");
  const SurfaceLocator locator(to);
  const AreaSampler sampler(*from);
  shapes::Random random(seed);
  SurfaceGap gap;
  for (std::size_t i = 0; i < samples; ++i) {
    const double distance = locator.closest(sampler.draw(random)).distance;
    gap.largest = std::max(gap.largest, distance), gap.mean += distance / static_cast<double>(samples);
  }
  for (Index v = 0; v < from->vertex_count(); ++v)
    if (from->first_half_edge(v) != no_index)
      gap.largest = std::max(gap.largest, locator.closest(from->positions()[v]).distance);
  return gap;
}

}  // namespace geodrome::bench
