// SPDX-License-Identifier: MIT
#include "geodrome/engine/surface_locator.hpp"

#include <algorithm>
#include <utility>

#include "interfaces/internal/closest_point_tree.hpp"

namespace geodrome {

struct SurfaceLocator::Impl {
  detail::ClosestPointTree tree;
};

SurfaceLocator::SurfaceLocator(MeshPtr mesh) {
  if (!mesh || mesh->face_count() == 0)
    throw InputError(InputFault::empty, "there is no surface to look for closest points on: the mesh has no face");
  impl_ = std::make_unique<const Impl>(Impl{detail::ClosestPointTree(std::move(mesh))});
}

SurfaceLocator::~SurfaceLocator() = default;

ClosestPoint SurfaceLocator::closest(const Vec3& query, std::span<const Index> without) const {
  if (!is_finite(query)) throw InputError(InputFault::nonfinite, "a point to be located on the surface is not finite");
  const detail::FacePoint found =
      impl_->tree.closest(query, [&](Index face) { return std::ranges::binary_search(without, face); });
  return {found.at(), std::sqrt(found.point.squared_distance)};
}

}  // namespace geodrome
